// The Morton curve through the cube [-1, 1]: points near in space are mostly near along it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "arris/types.h"

namespace arris {

// Spreads the low 21 bits of x to every third bit.
constexpr std::uint64_t spread_bits(std::uint64_t x) noexcept {
  x = (x | x << 32) & 0x001F00000000FFFF;
  x = (x | x << 16) & 0x001F0000FF0000FF;
  x = (x | x << 8) & 0x100F00F00F00F00F;
  x = (x | x << 4) & 0x10C30C30C30C30C3;
  return (x | x << 2) & 0x1249249249249249;
}

// Of the cell that p is in, 21 bits an axis. Points outside the cube count to the nearest cell.
inline std::uint64_t morton_key(Vec3 p) noexcept {
  const auto cell = [](double c) {
    return static_cast<std::uint64_t>(std::clamp((c + 1) * 0x1p20, 0.0, 0x1p21 - 1));
  };
  return spread_bits(cell(p.x)) | spread_bits(cell(p.y)) << 1 | spread_bits(cell(p.z)) << 2;
}

}  // namespace arris
