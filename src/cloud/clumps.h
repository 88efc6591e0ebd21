// Groups of points that are no part of the model: clumps, and strays among themselves.
#pragma once

#include <cstdint>
#include <vector>

#include "cloud/neighbours.h"

namespace arris {

// Whether two neighbours at this distance belong together; else they may through others only.
bool are_linked(double distance, double reach_a, double reach_b) noexcept;

// 1 for every point left in a group that is too small or too thin to bound a solid beside the
// largest one, is spread less evenly than it, or that fills space instead of a surface. Groups are
// joined through neighbours at distances comparable with the reach of both. Complexity: O(n) near
// enough.
std::vector<std::uint8_t> find_clumps(const Neighbours& neighbours);

}  // namespace arris
