#include "compare/ndc.h"

#include <cmath>
#include <numeric>
#include <vector>

#include "base/vec.h"
#include "compare/distances.h"
#include "compare/sampling.h"

namespace arris::compare {
namespace {

// The constants of the published evaluation. Lengths are in its unit: the diagonal of the truth.
constexpr std::size_t points_drawn = 100000;
constexpr double neighbourhood = 0.004;
constexpr double most_aligned = 0.2;  // |cos| of 78.5 degrees
constexpr double tolerance = 0.005;

constexpr std::uint64_t stream = 100;  // of draws; the truth's is the next
constexpr std::size_t points_per_chunk = 1024;

// Points and the elements {i, i, i} that a tree of them is made of.
struct Points {
  std::vector<Vec3> at;
  std::vector<Triangle> elements;

  NearestElement tree(Job& job) const {
    std::vector<Index> all(at.size());
    std::iota(all.begin(), all.end(), Index{0});
    return {at, elements, std::move(all), job.threads()};
  }
  void add(Vec3 p) {
    const auto i = static_cast<Index>(at.size());
    at.push_back(p);
    elements.push_back({i, i, i});
  }
};

// Of points drawn uniformly, those with another near them whose normal differs.
Points edge_points(const Surface& surface, std::uint64_t seed, std::uint64_t own_stream, Job& job) {
  std::vector<SurfacePoint> drawn(points_drawn);
  for_chunks(job, points_drawn, points_per_chunk, 0, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Draw draw(seed, own_stream, i);
      const double share = draw.unit();
      drawn[i] = point_on(surface, share, draw);
    }
  });
  Points all;
  for (const SurfacePoint& p : drawn) all.add(p.at);
  const NearestElement tree = all.tree(job);
  std::vector<std::uint8_t> at_edge(points_drawn);
  for_chunks(job, points_drawn, points_per_chunk, 0, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !job.cancelled(); ++i) {
      const Vec3 normal = surface.normals[drawn[i].triangle];
      tree.for_each_within(drawn[i].at, neighbourhood, [&](Index j) {
        if (std::abs(dot(normal, surface.normals[drawn[j].triangle])) < most_aligned)
          at_edge[i] = 1;
      });
    }
  });
  Points found;
  for (std::size_t i = 0; i < points_drawn; ++i)
    if (at_edge[i] != 0) found.add(drawn[i].at);
  return found;
}

struct Match {
  double share = 0, mean_square = 0;
};

Match match(const Points& points, const Points& others, Job& job) {
  const NearestElement tree = others.tree(job);
  Match sums;
  for (const Vec3 p : points.at) {
    const double d = tree(p).distance;
    sums.share += d < tolerance;
    sums.mean_square += d * d;
  }
  const auto n = static_cast<double>(points.at.size());
  return {sums.share / n, sums.mean_square / n};
}

}  // namespace

NdcScore ndc_edges(const Surface& result, const Surface& truth, const CompareOptions& options,
                   Job& job) {
  Points of_result = edge_points(result, options.seed, stream, job);
  const Points of_truth = edge_points(truth, options.seed, stream + 1, job);
  NdcScore s;
  s.points_result = of_result.at.size();
  s.points_truth = of_truth.at.size();
  if (of_truth.at.empty()) {  // the published evaluation counts this as right
    s.edge.f1 = 1;
    s.chamfer = 0;
    return s;
  }
  if (of_result.at.empty()) of_result.add({});  // and puts a point at the centre here
  const Match precision = match(of_result, of_truth, job), recall = match(of_truth, of_result, job);
  s.edge = score(precision.share, recall.share);
  s.chamfer = precision.mean_square + recall.mean_square;
  return s;
}

}  // namespace arris::compare
