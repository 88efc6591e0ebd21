#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/vec.h"
#include "compare/distances.h"
#include "compare/sampling.h"
#include "compare/sharp_edges.h"

namespace arris::compare {
namespace {

constexpr std::size_t samples_per_chunk = 1024;

// Distance between samples of edges, in diagonals; more where edges are so long that there would be
// more samples than the limit.
constexpr double edge_spacing = 0.001, most_edge_samples = 500000;

NearestElement tree_of(const Surface& surface, const std::vector<Triangle>& elements, Job& job) {
  std::vector<Index> all(elements.size());
  std::iota(all.begin(), all.end(), Index{0});
  return {surface.points, elements, std::move(all), job.threads()};
}

// From samples of one set of edges to another.
struct Match {
  double within_loose = undefined, within_strict = undefined, mean = undefined;
};

Vec3 point_along(const Surface& surface, const Features& edges, double at) {
  const auto& until = edges.length_until;
  const auto it = std::upper_bound(until.begin(), until.end(), at);
  const auto i = std::min(static_cast<std::size_t>(it - until.begin()), until.size() - 1);
  const double start = i == 0 ? 0 : until[i - 1];
  const Vec3 a = surface.points[edges.edges[i][0]], b = surface.points[edges.edges[i][1]];
  return a + std::clamp((at - start) / (until[i] - start), 0.0, 1.0) * (b - a);
}

Match sum_of(const std::vector<Match>& chunks, std::size_t samples) {
  Match all{0, 0, 0};
  for (const Match& chunk : chunks) {
    all.within_loose += chunk.within_loose;
    all.within_strict += chunk.within_strict;
    all.mean += chunk.mean;
  }
  const auto n = static_cast<double>(samples);
  return {all.within_loose / n, all.within_strict / n, all.mean / n};
}

// Samples evenly along all edges, one after the other.
Match match_edges(const Surface& surface, const Features& edges, const Surface& other,
                  const Features& other_edges, Job& job) {
  if (edges.edges.empty()) return {};
  if (other_edges.edges.empty()) return {0, 0, undefined};
  const NearestElement tree = tree_of(other, other_edges.edges, job);
  const double total = edges.length();
  const double spacing = std::max(edge_spacing, total / most_edge_samples);
  const auto n = static_cast<std::size_t>(std::max(1.0, std::round(total / spacing)));
  std::vector<Match> chunks((n + samples_per_chunk - 1) / samples_per_chunk);
  for_chunks(job, n, samples_per_chunk, 0, 0, [&](std::size_t begin, std::size_t end) {
    Match sums{0, 0, 0};
    for (std::size_t i = begin; i < end && !job.cancelled(); ++i) {
      const double at = (static_cast<double>(i) + 0.5) / static_cast<double>(n) * total;
      const double d = tree(point_along(surface, edges, at)).distance;
      sums.within_loose += d <= loose_tolerance;
      sums.within_strict += d <= strict_tolerance;
      sums.mean += d;
    }
    chunks[begin / samples_per_chunk] = sums;
  });
  return sum_of(chunks, n);
}

// Share of the corners with one of the others near them.
double match_corners(const Surface& surface, const Features& features, const Surface& other,
                     const Features& others, Job& job) {
  if (features.corners.empty()) return undefined;
  if (others.corners.empty()) return 0;
  const NearestElement tree = tree_of(other, others.corners, job);
  std::size_t hits = 0;
  for (const Triangle& corner : features.corners)
    hits += tree(surface.points[corner[0]]).distance <= loose_tolerance;
  return static_cast<double>(hits) / static_cast<double>(features.corners.size());
}

}  // namespace

FeatureScore match_features(const Surface& result, const Features& of_result, const Surface& truth,
                            const Features& of_truth, double dihedral, Job& job) {
  const Match precision = match_edges(result, of_result, truth, of_truth, job);
  const Match recall = match_edges(truth, of_truth, result, of_result, job);
  FeatureScore s;
  s.dihedral = dihedral;
  s.loose = score(precision.within_loose, recall.within_loose);
  s.strict = score(precision.within_strict, recall.within_strict);
  s.chamfer = (precision.mean + recall.mean) / 2;
  s.length_result = of_result.length();
  s.length_truth = of_truth.length();
  s.corners = score(match_corners(result, of_result, truth, of_truth, job),
                    match_corners(truth, of_truth, result, of_result, job));
  s.corners_result = of_result.corners.size();
  s.corners_truth = of_truth.corners.size();
  return s;
}

}  // namespace arris::compare
