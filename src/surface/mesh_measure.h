// Volume and area of a mesh, and the frame in which they are computed.
#pragma once

#include <span>

#include "arris/types.h"

namespace arris {

// Coordinates p * scale - origin are of the order of 1 and centred, so that sums of products
// neither overflow nor cancel needlessly far from zero. The scale is a power of two.
struct Frame {
  double scale = 1;
  int exponent = 0;  // scale = 2^-exponent
  Vec3 origin;       // after scaling

  Vec3 map(Vec3 p) const noexcept {
    return {p.x * scale - origin.x, p.y * scale - origin.y, p.z * scale - origin.z};
  }
};

// From the bounding box of `points`, which must be finite.
Frame measuring_frame(std::span<const Vec3> points);

struct MeshMeasure {
  double volume = 0;  // signed; meaningful if the mesh is closed
  double area = 0;
};

// Sums over all triangles, whose corners must be valid; the same for every number of threads.
// Clamped to the range of doubles, never infinite. `frame` is that of the points.
MeshMeasure measure(std::span<const Vec3> points, std::span<const Triangle> triangles,
                    const Frame& frame, unsigned threads);

}  // namespace arris
