// Clumps that touch the surface, which no gap tells from it.
#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "cloud/neighbours.h"

namespace arris {

// 1 for every point of a clump that is left, linked to the surface or not: where points are crowded
// that have no free side, and what is linked to there and is so to a lesser degree (two thresholds
// as in Canny, "A computational approach to edge detection", 1986). Where the model is spread at
// random nothing is found. Complexity: O(n), parallel but for the spreading.
std::vector<std::uint8_t> find_thickets(const Neighbours& near, Job& job);

}  // namespace arris
