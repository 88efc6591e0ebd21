// Corners of a triangle by their vertex, which must be one of it.
#pragma once

#include <cstddef>

#include "arris/types.h"

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

}  // namespace arris
