#include "noise/adaptive_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/parallel.h"
#include "base/vec.h"

namespace arris {
namespace {

constexpr std::size_t smallest_patch = 10, largest_patch = 256;
constexpr double patch_growth = 1.5;  // of the number of samples
constexpr double wanted_error = 0.01;  // of the spacing

// A patch must be wider than the noise is deep before its plane means anything.
constexpr double least_radius = 3;  // in levels of noise

// Samples farther from the fit than half the radius belong to another sheet.
constexpr double other_sheet = 0.5, least_other_sheet = 4;  // of the radius; of the level

// How far the statistics of the residuals may exceed their expectation, in standard deviations, and
// how much the estimated level itself may be too low.
constexpr double tolerance = 3, level_slack = 1.1;

// A quadric has four times the variance of a plane in the middle of a patch, so it must explain
// clearly more samples to be preferred.
constexpr double quadric_gain = 1.5;

// Residuals are compared with noise also in their means over parts of the patch: a middle and a
// ring of sectors, where noise averages out and a bent surface shows.
constexpr std::size_t sectors = 8, cells = sectors + 1;
constexpr double middle = 0.5;  // of the radius

std::size_t cell_of(Vec3 local, double radius) {
  if (local.x * local.x + local.y * local.y < middle * middle * radius * radius) return sectors;
  const double ax = std::abs(local.x), ay = std::abs(local.y);
  return (local.x < 0 ? 1u : 0u) + (local.y < 0 ? 2u : 0u) + (ax < ay ? 4u : 0u);
}

double limit(double freedom) {
  return freedom + tolerance * std::sqrt(2 * freedom);
}

// Are the residuals what noise of this level leaves?
bool explained(const HeightFit& fit, const std::vector<Vec3>& local, double level) {
  std::array<double, cells> sum{}, count{};
  double squares = 0;
  for (Vec3 p : local) {
    const double r = p.z - fit.height(p.x, p.y);
    squares += r * r;
    const std::size_t cell = cell_of(p, fit.radius);
    sum[cell] += r;
    count[cell] += 1;
  }
  const double variance = level_slack * level_slack * level * level;
  const double n = static_cast<double>(local.size());
  if (squares > variance * limit(n - fit.terms)) return false;
  double means = 0;
  for (std::size_t j = 0; j < cells; ++j)
    if (count[j] > 0) means += sum[j] * sum[j] / count[j];
  return means <= variance * limit(static_cast<double>(cells) - fit.terms);
}

// The patch in growth at one sample.
class Growth {
 public:
  Growth(const std::vector<Vec3>& points, Vec3 centre, double level)
      : points_(points), centre_(centre), level_(level) {}

  PatchFit grow(const std::vector<NearestSample::Hit>& hits) {
    for (std::size_t n = std::min(smallest_patch, hits.size());;) {
      if (hits[n - 1].distance >= least_radius * level_ && !step(hits, n)) break;
      if (n == hits.size()) break;
      n = std::min(hits.size(),
                   static_cast<std::size_t>(patch_growth * static_cast<double>(n)));
    }
    const double gain = quadric_gain * plane_.count;
    return quadric_.count > gain ? quadric_ : plane_;
  }

 private:
  // Tries the patch of n samples; false if nothing smooth fits it.
  bool step(const std::vector<NearestSample::Hit>& hits, std::size_t n) {
    gather(hits, n);
    const double radius = hits[n - 1].distance;
    if (plane_alive_) plane_alive_ = attempt(plane_terms, radius, plane_);
    if (quadric_alive_ && local_.size() >= smallest_patch)
      quadric_alive_ = attempt(quadric_terms, radius, quadric_);
    return plane_alive_ || quadric_alive_;
  }

  bool attempt(int terms, double radius, PatchFit& best) {
    HeightFit fit = fit_heights(frame_, local_, radius, terms);
    if (fit.terms == 0 || !explained(fit, local_, level_)) return false;
    normal_ = fit.offset(centre_).normal;
    best = {std::move(fit), static_cast<Index>(local_.size())};
    return true;
  }

  void gather(const std::vector<NearestSample::Hit>& hits, std::size_t n) {
    local_.clear();
    if (!normal_) {
      for (std::size_t i = 0; i < n; ++i) local_.push_back(points_[hits[i].index]);
      normal_ = least_variance_direction(local_);
      local_.clear();
    }
    frame_ = frame_at(centre_, *normal_);
    const double gate = std::max(other_sheet * hits[n - 1].distance, least_other_sheet * level_);
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 p = frame_.to_frame(points_[hits[i].index]);
      if (std::abs(p.z) <= gate) local_.push_back(p);
    }
  }

  const std::vector<Vec3>& points_;
  Vec3 centre_;
  double level_;
  std::optional<Vec3> normal_;
  Frame frame_;
  std::vector<Vec3> local_;
  PatchFit plane_, quadric_;
  bool plane_alive_ = true, quadric_alive_ = true;
};

}  // namespace

double PatchFit::variance(double reach) const noexcept {
  const double q = reach * reach, n = count;
  const double plane = 1 + 4 * q;
  if (fit.terms == plane_terms) return plane / n;
  return (plane + 3 * (2 * q - 1) * (2 * q - 1) + 6 * q * q) / n;
}

std::size_t patch_limit(double level, double spacing) noexcept {
  const double needed = level / (wanted_error * spacing);
  return static_cast<std::size_t>(std::clamp(needed * needed, 4.0 * smallest_patch,
                                             static_cast<double>(largest_patch)));
}

std::vector<PatchFit> fit_patches(const std::vector<Vec3>& points, const NearestSample& tree,
                                  const std::vector<double>& level, Job& job) {
  std::vector<PatchFit> fits(points.size());
  parallel_chunks(points.size(), 256, job.threads(), [&](std::size_t begin, std::size_t end) {
    std::vector<NearestSample::Hit> hits;
    for (std::size_t i = begin; i < end; ++i) {
      if (!(level[i] > 0)) continue;
      tree.nearest(points[i], 7, hits);
      const double spacing = hits.back().distance / 1.2;
      tree.nearest(points[i], patch_limit(level[i], spacing), hits);
      fits[i] = Growth(points, points[i], level[i]).grow(hits);
    }
  });
  return fits;
}

}  // namespace arris
