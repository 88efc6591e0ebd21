#include "noise/sites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "noise/height_fit.h"

namespace arris {
namespace {

// Deviations of places nearby are pooled by this quantile: an edge may run through two thirds of
// the neighbourhoods.
constexpr double pooled_quantile = 0.3, normal_quantile = -0.5244;

// From a plane; see noise_level.cpp.
constexpr std::size_t plane_size = 6;

// Six samples with noise are never flat: less than this share of the usual deviation has a chance
// of a hundred thousandth. Two such places of 32 are proof of an edged surface without noise.
constexpr double flat_share = 0.02;
constexpr std::ptrdiff_t fewest_flat = 2;

// Residuals of two sheets taken for one have two humps: a kurtosis below 2, where noise has 3.
constexpr double least_kurtosis = 2.2;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The pooled quantile of a deviation with so many degrees of freedom, over the true deviation
// (Wilson and Hilferty's approximation of the chi-squared distribution, 1931).
double quantile_of_deviation(double freedom) {
  const double v = 2 / (9 * freedom);
  return std::pow(1 - v + normal_quantile * std::sqrt(v), 1.5);
}

double pooled_deviation(const HeightFit& fit, const std::vector<Vec3>& local) {
  if (fit.terms == 0) return infinity;
  const double freedom = static_cast<double>(local.size()) - fit.terms;
  return residual_deviation(fit, local) / quantile_of_deviation(freedom);
}

// Fourth moment of the residuals over the square of the second.
double kurtosis(const HeightFit& fit, const std::vector<Vec3>& local) {
  double second = 0, fourth = 0;
  for (Vec3 p : local) {
    const double r = p.z - fit.height(p.x, p.y);
    second += r * r;
    fourth += r * r * r * r;
  }
  return second > 0 ? fourth * static_cast<double>(local.size()) / (second * second) : 3;
}

void measure(const std::vector<Vec3>& points, Vec3 centre,
             const std::vector<NearestSample::Hit>& hits, std::size_t level,
             DeviationCurve& curve) {
  const std::size_t n = patch_sizes[level];
  std::vector<Vec3> patch(n);
  for (std::size_t i = 0; i < n; ++i) patch[i] = points[hits[i].index];
  const Frame frame = frame_at(centre, least_variance_direction(patch));
  for (Vec3& p : patch) p = frame.to_frame(p);
  const double radius = hits[n - 1].distance;
  curve.radius[level] = radius;
  const HeightFit fit = fit_heights(frame, patch, radius, quadric_terms);
  curve.deviation[level] = pooled_deviation(fit, patch);
  curve.known = level + 1;
  if (level > 0) {
    if (fit.terms > 0 && kurtosis(fit, patch) < least_kurtosis) curve.deviation[level] = infinity;
    return;
  }
  patch.resize(plane_size);
  curve.plane = pooled_deviation(
      fit_heights(frame, patch, hits[plane_size - 1].distance, plane_terms), patch);
}

DeviationCurve measure_curve(const std::vector<Vec3>& points, const NearestSample& tree,
                             Vec3 centre) {
  DeviationCurve curve;
  std::vector<NearestSample::Hit> hits;
  for (std::size_t level = 0; level < patch_sizes.size(); ++level) {
    if (points.size() < 2 * patch_sizes[level]) break;
    if (level > 1 && curve.deviation[level - 2] * wide_enough < curve.radius[level - 2]) break;
    if (hits.size() < patch_sizes[level])
      tree.nearest(centre, patch_sizes[std::max<std::size_t>(level, 1)], hits);
    if (hits.size() < patch_sizes[level]) break;
    measure(points, centre, hits, level, curve);
  }
  return curve;
}

double pooled_value(std::vector<double>& values) {
  const auto at = values.begin() +
                  static_cast<std::ptrdiff_t>(pooled_quantile * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Pools the curves of the sites nearby.
DeviationCurve pool(const std::vector<DeviationCurve>& curves,
                    const std::vector<NearestSample::Hit>& hits) {
  DeviationCurve pooled;
  std::vector<double> deviations, radii, planes;
  for (const auto& h : hits)
    if (curves[h.index].known > 0) planes.push_back(curves[h.index].plane);
  if (!planes.empty()) pooled.plane = pooled_value(planes);
  const auto flat = std::count_if(planes.begin(), planes.end(),
                                  [&](double d) { return d < flat_share * pooled.plane; });
  pooled.flat = flat >= fewest_flat;
  for (std::size_t j = 0; j < patch_sizes.size(); ++j) {
    deviations.clear();
    radii.clear();
    for (const auto& h : hits)
      if (curves[h.index].known > j) {
        deviations.push_back(curves[h.index].deviation[j]);
        radii.push_back(curves[h.index].radius[j]);
      }
    if (2 * deviations.size() < hits.size()) break;
    pooled.deviation[j] = pooled_value(deviations);
    pooled.radius[j] = pooled_value(radii);
    pooled.known = j + 1;
  }
  return pooled;
}

}  // namespace

Sites::Sites(const std::vector<Vec3>& points, const NearestSample& tree, std::vector<Vec3> at)
    : points_(points),
      tree_(tree),
      at_(std::move(at)),
      near_(at_),
      curves_(at_.size()),
      measured_(at_.size(), 0) {}

void Sites::find_near(std::size_t i, std::vector<NearestSample::Hit>& hits) const {
  find_near(at_[i], pooled_sites, hits);
}

void Sites::find_near(Vec3 p, std::size_t count, std::vector<NearestSample::Hit>& hits) const {
  near_.nearest(p, count, hits);
}

void Sites::measure(const std::vector<Index>& which, Job& job) {
  parallel_chunks(which.size(), 256, job.threads(), [&](std::size_t begin, std::size_t end) {
    if (job.cancelled()) return;
    for (std::size_t k = begin; k < end; ++k) {
      if (measured_[which[k]]) continue;
      curves_[which[k]] = measure_curve(points_, tree_, at_[which[k]]);
      measured_[which[k]] = 1;
    }
  });
  job.tick(0);
}

DeviationCurve Sites::pooled(std::size_t i, std::vector<NearestSample::Hit>& hits) const {
  find_near(i, hits);
  return pool(curves_, hits);
}

}  // namespace arris
