// Corners of a triangle by their vertex, which must be one of it; its middle.
#pragma once

#include <cstddef>
#include <vector>

#include "base/vec.h"

namespace arris {

// Where v stands in t: 0, 1 or 2.
inline std::size_t corner_of(const Triangle& t, Index v) noexcept {
  return t[0] == v ? 0 : t[1] == v ? 1 : 2;
}

// The end of the side of t that leaves v. On a closed surface those of a star are its whole ring.
inline Index next_corner(const Triangle& t, Index v) noexcept {
  return t[(corner_of(t, v) + 1) % 3];
}

// The start of the side of t that comes to v.
inline Index previous_corner(const Triangle& t, Index v) noexcept {
  return t[(corner_of(t, v) + 2) % 3];
}

// Mean of the corners.
inline Vec3 middle_of(const std::vector<Vec3>& points, const Triangle& t) noexcept {
  return 1.0 / 3 * (points[t[0]] + points[t[1]] + points[t[2]]);
}

}  // namespace arris
