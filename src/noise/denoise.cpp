#include "noise/denoise.h"

#include <algorithm>

#include "cloud/nearest.h"
#include "noise/adaptive_fit.h"
#include "noise/noise_level.h"
#include "noise/project.h"

namespace arris {

Denoised denoise(const std::vector<Vec3>& points, double level, Job& job) {
  Denoised result;
  const NearestSample tree(points);
  result.level =
      level < 0 ? estimate_noise(points, tree, job) : std::vector<double>(points.size(), level);
  std::vector<double> sorted = result.level;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  result.median_level = *middle;
  result.highest_level = *std::max_element(middle, sorted.end());
  if (result.highest_level == 0) {
    result.points = points;
    result.backing.resize(points.size(), 0);
    return result;
  }
  job.tick(0.3);
  const std::vector<PatchFit> fits = fit_patches(points, tree, result.level, job);
  job.tick(0.7);
  Projection projection = project_samples(points, result.level, fits, job);
  result.points = std::move(projection.points);
  result.backing = std::move(projection.backing);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!(result.points[i] == points[i])) ++result.moved;
  return result;
}

}  // namespace arris
