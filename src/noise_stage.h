// The steps of the pipeline that move noisy samples.
#pragma once

#include <cstdint>
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

// By means (feature/settle.h) on a rough surface, on patches (feature/refit.h) on one that shows
// its pieces clearly.
enum class Settling : std::uint8_t { means, patches };

// Moves noisy samples onto the smooth pieces of the surface of `labels`.
void settle(const PointCloud& cloud, const Noise& noise, const Stage& stage, const Labels& labels,
            Settling how, Samples& samples, Job& job);

}  // namespace arris
