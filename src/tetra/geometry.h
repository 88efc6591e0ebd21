// Measures of tetrahedra and of the point set they join: circumballs and sample spacing.
#pragma once

#include <vector>

#include "tetra/stars.h"
#include "tetra/tet_mesh.h"

namespace arris {

// Circumcentre and circumradius, good to about 8 digits whatever the shape: on slivers, of which a
// face sampled exactly has many, the sums are done in double-double numbers. The radius is infinity
// where even those do not suffice.
struct Circumball {
  Vec3 centre;
  double radius = 0;
};
Circumball circumball(Vec3 a, Vec3 b, Vec3 c, Vec3 d);
Circumball circumball(const TetMesh& mesh, Tet t);  // t finite

// One per finite tetrahedron.
std::vector<Circumball> circumballs(const TetMesh& mesh, unsigned threads);

// Spacing h of the samples round each point: the length of its spacing_rank-th shortest Delaunay
// edge, then the median of that over the point and the ends of those edges. > 0, even where points
// lie so close that squared distances underflow.
std::vector<double> sample_spacing(const TetMesh& mesh, const Stars& stars, unsigned threads);

// Mean of the spacing at the four vertices of a finite tetrahedron.
inline double mean_spacing(const TetMesh& mesh, const std::vector<double>& spacing, Tet t) {
  const auto& v = mesh.vertices[t];
  return (spacing[v[0]] + spacing[v[1]] + spacing[v[2]] + spacing[v[3]]) / 4;
}

// The largest facet of a finite tetrahedron, twice its area, and the height over it: the least one.
struct TetBase {
  double twice_area = 0, height = 0;
};
TetBase largest_base(const TetMesh& mesh, Tet t);

// A tetrahedron whose least height is below this many spacings has no inside to speak of, e.g. four
// samples of one edge or of one plane: its two sides cost the same but for rounding. Far below what
// a surface shows, far above the rounding of float coordinates (about 1e-5 spacings).
inline constexpr double sliver_height = 1e-3;

}  // namespace arris
