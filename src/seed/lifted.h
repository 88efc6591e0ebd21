// Seeds where points were lifted off a surface that is right but for the bulge between its points.
#pragma once

#include <vector>

#include "seed/seeds.h"
#include "tetra/tet_mesh.h"

namespace arris {

// A point added over the surface of a labelled mesh.
struct LiftedPoint {
  Vec3 foot;                  // the point of the old surface that it was lifted from
  Index near = no_index;      // a point of the old mesh near it
  std::vector<Vec3> normals;  // outward, of the surfaces that it lies on; two or more on a feature
};

// The points of `fine` are those of `coarse` and then `lifted`. Tetrahedra that were there before,
// as `former` says (Extension), keep their label for good. Of the new ones, small flat ones along
// the surface lie in the bulge: all their corners are on the true surface, and the facets of the
// restricted Delaunay triangulation, which follows it best, part those whose circumcentre is inside
// from those whose is outside, seen from the tangent planes of the lifted points (Boissonnat and
// Oudot, "Provably good sampling and meshing of surfaces", 2005). Others take the label that
// `coarse` has where their centroid would be without the lift; for near slivers, which are on a
// plane with a trace of noise, that is a hint; long flat ones are free. Labels are firm if the ball
// is large, as in find_seeds. Complexity: near-linear, as both meshes are numbered along the same
// curve.
Seeds lifted_seeds(const TetMesh& coarse, const Labels& labels, const Seeds& seeds,
                   const TetMesh& fine, const std::vector<Tet>& former,
                   const std::vector<LiftedPoint>& lifted, const std::vector<double>& spacing,
                   Job& job);

}  // namespace arris
