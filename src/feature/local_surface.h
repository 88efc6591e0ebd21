// A quadric height field over a tangent frame: what is sensed of the surface on one side of a
// sample.
#pragma once

#include <array>

#include "arris/types.h"
#include "base/vec.h"

namespace arris {

// z = c0 + c1 x + c2 y + c3 x² + c4 xy + c5 y² in the frame (u, v, n) at `origin`.
struct LocalSurface {
  Vec3 origin;
  Vec3 u, v, n;  // orthonormal; n outward
  std::array<double, 6> c{};

  // Signed distance to first order: positive outside.
  double distance(Vec3 p) const noexcept;
  // Outward unit normal at the foot of p.
  Vec3 normal(Vec3 p) const noexcept;
};

// A plane through `origin` with unit normal `n`.
LocalSurface tangent_plane(Vec3 origin, Vec3 n) noexcept;

}  // namespace arris
