// The steps of the pipeline that move noisy samples.
#pragma once

#include <vector>

#include "arris/reconstruct.h"
#include "base/job.h"
#include "cloud/prepare.h"
#include "stage.h"

namespace arris {

// Per input point: the deviation of its noise, and how many samples its new place is the mean of.
// Both empty if no sample moved.
struct Noise {
  std::vector<double> level, backing;
};

// Moves the samples onto the surface that they were measured of (noise/denoise.h), and fills in the
// report what noise there is.
Noise remove_noise(const PointCloud& cloud, const Options& options, Samples& samples,
                   Report& report, Job& job);

// Moves noisy samples onto the smooth pieces of the surface of `labels` (feature/settle.h).
void settle(const PointCloud& cloud, const Noise& noise, const Stage& stage, const Labels& labels,
            Samples& samples, Job& job);

}  // namespace arris
