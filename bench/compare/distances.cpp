#include "compare/distances.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/vec.h"
#include "compare/sampling.h"

namespace arris::compare {
namespace {

constexpr std::size_t samples_per_chunk = 1024;

constexpr double bad_normal = 15;  // degrees

// Degrees between two unit vectors; accurate for small angles too.
double angle(Vec3 a, Vec3 b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

// Sums over the samples of a chunk, or means over all.
void add(Directed& sums, double distance, double turned) {
  const double folded = std::min(turned, 180 - turned);
  sums.mean += distance;
  sums.rms += distance * distance;
  sums.max = std::max(sums.max, distance);
  sums.within_loose += distance <= loose_tolerance;
  sums.within_strict += distance <= strict_tolerance;
  sums.normal_error += folded;
  sums.normal_error_oriented += turned;
  sums.normal_bad += folded > bad_normal;
}

Directed mean_of(const std::vector<Directed>& chunks, std::size_t samples) {
  Directed all;
  for (const Directed& chunk : chunks) {
    all.mean += chunk.mean;
    all.rms += chunk.rms;
    all.max = std::max(all.max, chunk.max);
    all.within_loose += chunk.within_loose;
    all.within_strict += chunk.within_strict;
    all.normal_error += chunk.normal_error;
    all.normal_error_oriented += chunk.normal_error_oriented;
    all.normal_bad += chunk.normal_bad;
  }
  for (double* sum : {&all.mean, &all.rms, &all.within_loose, &all.within_strict, &all.normal_error,
                      &all.normal_error_oriented, &all.normal_bad})
    *sum /= static_cast<double>(samples);
  all.rms = std::sqrt(all.rms);
  return all;
}

double percentile_99(std::vector<double>& values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 99 / 100);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// The furthest vertex of the surface from the other one.
double furthest_vertex(const Surface& surface, const Surface& other, Job& job, double from,
                       double to) {
  const std::size_t n = surface.used.size();
  std::vector<double> furthest((n + samples_per_chunk - 1) / samples_per_chunk, 0);
  for_chunks(job, n, samples_per_chunk, from, to, [&](std::size_t begin, std::size_t end) {
    double& chunk = furthest[begin / samples_per_chunk];
    for (std::size_t i = begin; i < end && !job.cancelled(); ++i)
      chunk = std::max(chunk, (*other.tree)(surface.points[surface.used[i]]).distance);
  });
  return *std::max_element(furthest.begin(), furthest.end());
}

}  // namespace

Directed directed_distances(const Surface& surface, const Surface& other,
                            const CompareOptions& options, std::uint64_t stream, Job& job,
                            double from, double to) {
  const std::size_t n = options.samples;
  std::vector<double> distances(n);
  std::vector<Directed> chunks((n + samples_per_chunk - 1) / samples_per_chunk);
  const double middle = (from + to) / 2;
  for_chunks(job, n, samples_per_chunk, from, middle, [&](std::size_t begin, std::size_t end) {
    Directed& sums = chunks[begin / samples_per_chunk];
    for (std::size_t i = begin; i < end && !job.cancelled(); ++i) {
      Draw draw(options.seed, stream, i);
      // Stratified: one sample in every n-th part of the area.
      const double share = (static_cast<double>(i) + draw.unit()) / static_cast<double>(n);
      const SurfacePoint p = point_on(surface, share, draw);
      const NearestElement::Hit hit = (*other.tree)(p.at);
      distances[i] = hit.distance;
      add(sums, hit.distance, angle(surface.normals[p.triangle], other.normals[hit.element]));
    }
  });
  Directed result = mean_of(chunks, n);
  result.p99 = percentile_99(distances);
  result.max = std::max(result.max, furthest_vertex(surface, other, job, middle, to));
  return result;
}

Score score(double precision, double recall) {
  Score s{precision, recall, 0};
  if (std::isnan(precision) && std::isnan(recall))
    s.f1 = undefined;
  else if (precision > 0 && recall > 0)
    s.f1 = 2 * precision * recall / (precision + recall);
  return s;
}

}  // namespace arris::compare
