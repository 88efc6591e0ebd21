#include "surface/crowd.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "surface/star_intersections.h"
#include "surface/triangle_intersection.h"

namespace arris {
namespace {

constexpr std::size_t places_per_chunk = 256;

}  // namespace

void add_pair(Index t, Index u, Defects& pairs) {
  const std::array<Index, 3> pair = {std::min(t, u), std::max(t, u), no_index};
  pairs.example = pairs.count++ == 0 ? pair : std::min(pairs.example, pair);
}

void add(const Intersections& part, Intersections& all) {
  const bool lower =
      all.pairs.count == 0 || (part.pairs.count > 0 && part.pairs.example < all.pairs.example);
  if (lower) all.pairs.example = part.pairs.example;
  all.pairs.count += part.pairs.count;
  all.tested += part.tested;
}

void test_pair(std::span<const Vec3> points, std::span<const Triangle> triangles, Index t, Index u,
               Intersections& found) {
  ++found.tested;
  if (facets_meet(make_facet(points, triangles[t]), make_facet(points, triangles[u])))
    add_pair(t, u, found.pairs);
}

Crowd::Crowd(std::span<const Vec3> points, std::span<const Triangle> triangles, const BoxTree& tree,
             std::vector<std::size_t> positions, std::size_t least_hub)
    : points_(points),
      triangles_(triangles),
      boxes_(tree),
      positions_(std::move(positions)),
      tree_({}) {
  find_hubs(least_hub);
  fill_fans();
  std::vector<LongTriangle> members;
  members.reserve(positions_.size());
  for (std::size_t p : positions_) members.push_back(make_long(boxes_.triangle(p)));
  tree_ = OrientedTree(std::move(members));
}

void Crowd::find_hubs(std::size_t least_hub) {
  std::vector<Index> corners;
  corners.reserve(3 * positions_.size());
  for (std::size_t p : positions_)
    for (Index v : triangles_[boxes_.triangle(p)]) corners.push_back(v);
  std::sort(corners.begin(), corners.end());
  for (std::size_t begin = 0, end; begin < corners.size(); begin = end) {
    for (end = begin; end < corners.size() && corners[end] == corners[begin];) ++end;
    if (end - begin >= least_hub) hubs_.push_back(corners[begin]);
  }
}

void Crowd::fill_fans() {
  fans_.resize(hubs_.size());
  if (fans_.empty()) return;
  auto next = positions_.begin();
  for (std::size_t p = 0; p < boxes_.size(); ++p) {
    const bool crowded = next != positions_.end() && *next == p;
    if (crowded) ++next;
    for (Index v : triangles_[boxes_.triangle(p)]) {
      const auto hub = std::lower_bound(hubs_.begin(), hubs_.end(), v);
      if (hub == hubs_.end() || *hub != v) continue;
      Fan& fan = fans_[static_cast<std::size_t>(hub - hubs_.begin())];
      fan.star.push_back(boxes_.triangle(p));
      fan.crowded.push_back(crowded);
    }
  }
}

bool Crowd::is_hub(Index v) const {
  return std::binary_search(hubs_.begin(), hubs_.end(), v);
}

LongTriangle Crowd::make_long(Index triangle) const {
  LongTriangle result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Index v = triangles_[triangle][k];
    result.corner[k] = boxes_.frame().map(points_[v]);
    if (is_hub(v)) result.hub[k] = v;
  }
  return result;
}

void Crowd::find_lower(std::size_t position, std::vector<std::uint32_t>& buffer,
                       Intersections& found) const {
  const Index t = boxes_.triangle(position);
  buffer.clear();
  tree_.find(make_long(t), buffer);
  for (std::uint32_t k : buffer)
    if (positions_[k] < position)
      test_pair(points_, triangles_, t, boxes_.triangle(positions_[k]), found);
}

// A pair with two common hubs is counted round the lower one.
Index Crowd::lowest_common_hub(Index t, Index u) const {
  Index lowest = no_index;
  for (Index v : triangles_[t])
    for (Index w : triangles_[u])
      if (v == w && v < lowest && is_hub(v)) lowest = v;
  return lowest;
}

Intersections Crowd::find_round(Index hub, const Fan& fan, Job& job) const {
  const StarArcs arcs(points_, triangles_, fan.star, hub);
  std::vector<Intersections> parts((fan.star.size() + places_per_chunk - 1) / places_per_chunk);
  parallel_chunks(fan.star.size(), places_per_chunk, job.threads(),
                  [&](std::size_t begin, std::size_t end) {
                    std::vector<std::uint32_t> partners;
                    for (std::size_t k = begin; k < end; ++k) {
                      if (job.cancelled()) return;  // the next tick throws
                      if (!fan.crowded[k]) continue;
                      arcs.partners_of(static_cast<std::uint32_t>(k), partners);
                      for (std::uint32_t j : partners)
                        if (lowest_common_hub(fan.star[k], fan.star[j]) == hub)
                          test_pair(points_, triangles_, fan.star[k], fan.star[j],
                                    parts[begin / places_per_chunk]);
                    }
                  });
  Intersections all;
  for (const Intersections& part : parts) add(part, all);
  return all;
}

Intersections Crowd::find_round_hubs(Job& job, double from, double to) const {
  Intersections all;
  for (std::size_t k = 0; k < fans_.size(); ++k) {
    job.tick(from + (to - from) * static_cast<double>(k) / static_cast<double>(fans_.size()));
    add(find_round(hubs_[k], fans_[k], job), all);
  }
  return all;
}

}  // namespace arris
