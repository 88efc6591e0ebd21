// Feature curves: the sharp edges of a mesh as polylines, the corners where they meet, and the
// smooth patches between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arris/context.h"
#include "arris/error.h"
#include "arris/types.h"

namespace arris {

// Whether the solid has its ridge (interior dihedral angle below 180 degrees) or its groove at a
// curve; `mixed` if neither makes up nine tenths of the length.
enum class CurveKind : std::uint8_t { convex, concave, mixed };

// The stable, lower-case name of a kind.
const char* name(CurveKind kind) noexcept;

// A chain of mesh edges. No mesh edge is on two curves. Angles are interior dihedral angles in
// degrees, in [0, 360]: 90 at the edge of a cube, 270 along the bottom of a groove, 180 where flat.
// They presume triangles that are counter-clockwise seen from outside.
struct FeatureCurve {
  std::vector<Index> vertices;  // in order; a closed curve does not repeat its first
  bool closed = false;
  CurveKind kind = CurveKind::mixed;
  double length = 0;            // user's unit
  double mean_angle = 180;      // weighted by length
  double sharpest_angle = 180;  // farthest from 180
};

// Where curves end: degree 1, a crease that fades out; 2, a sharp bend of one line; 3 or more, a
// corner. Curves that start and end there count twice.
struct FeatureCorner {
  Index vertex = no_index;
  Vec3 position;
  std::uint32_t degree = 0;
};

struct FeatureNetwork {
  std::vector<FeatureCurve> curves;    // ordered by their lowest mesh edge
  std::vector<FeatureCorner> corners;  // ascending by vertex
  std::vector<Index> patch;            // per triangle: its smooth patch, numbered from 0
  std::size_t patches = 0;             // a boundary of the mesh, too, ends a patch
};

// Finds the sharp edges of any mesh. An edge is sharp if the surface turns there by far more than
// its curvature round about explains; weaker edges count where they continue a sharper one, stubs
// of a few edges do not count (docs/method.md). Errors: usage (a triangle names a vertex that is
// not there), bad_points (a coordinate is not finite), out_of_memory, cancelled.
// Complexity: O(n log n) for n triangles.
Result<FeatureNetwork> find_features(const Mesh& mesh, const Context& context = {});

}  // namespace arris
