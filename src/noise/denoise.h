// The noise stage: estimate the level, fit patches of surface, move the samples onto them.
#pragma once

#include <cstdint>
#include <vector>

#include "arris/types.h"
#include "base/job.h"

namespace arris {

struct Denoised {
  std::vector<Vec3> points;     // bit-equal to the input where not moved
  std::vector<double> level;    // standard deviation of the noise along the normal, per point
  std::vector<double> backing;  // samples that the new place of each is the mean of; 0: not moved
  double median_level = 0, highest_level = 0;
  std::uint64_t moved = 0;
};

// `level` >= 0 is the noise of every point; negative: estimated from the points. With level 0, or
// where the estimate is 0, nothing moves. Units are those of the points.
// Complexity: O(n log n), up to 256 neighbours a point.
Denoised denoise(const std::vector<Vec3>& points, double level, Job& job);

}  // namespace arris
