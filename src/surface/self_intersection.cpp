#include "surface/self_intersection.h"

#include <algorithm>
#include <vector>

#include "base/failure.h"
#include "base/parallel.h"
#include "surface/triangle_intersection.h"

namespace arris {
namespace {

constexpr std::size_t positions_per_chunk = 1024;
constexpr std::size_t positions_per_tick = 64 * positions_per_chunk;

// Adds the pair, keeping the lowest as the example, in whatever order they come.
void add_pair(Defects& pairs, Index t, Index u) {
  const std::array<Index, 3> pair = {std::min(t, u), std::max(t, u), no_index};
  pairs.example = pairs.count++ == 0 ? pair : std::min(pairs.example, pair);
}

}  // namespace

Defects find_intersections(std::span<const Vec3> points, std::span<const Triangle> triangles,
                           const BoxTree& tree, Job& job, double from) {
  std::vector<Defects> parts((tree.size() + positions_per_chunk - 1) / positions_per_chunk);
  for (std::size_t start = 0; start < tree.size(); start += positions_per_tick) {
    job.tick(from + (1 - from) * static_cast<double>(start) / static_cast<double>(tree.size()));
    const std::size_t n = std::min(positions_per_tick, tree.size() - start);
    parallel_chunks(n, positions_per_chunk, job.threads(), [&](std::size_t begin, std::size_t end) {
      Defects& pairs = parts[(start + begin) / positions_per_chunk];
      for (std::size_t i = start + begin; i < start + end; ++i) {
        if (job.cancelled()) return;  // the next tick throws
        const Index t = tree.triangle(i);
        const Facet facet = make_facet(points, triangles[t]);
        tree.for_each_overlap(tree.box(i), i + 1, [&](std::size_t j) {
          const Index u = tree.triangle(j);
          if (facets_meet(facet, make_facet(points, triangles[u]))) add_pair(pairs, t, u);
        });
      }
    });
  }
  job.tick(1);
  Defects all;
  for (const Defects& part : parts) {
    const bool lower = all.count == 0 || (part.count > 0 && part.example < all.example);
    if (lower) all.example = part.example;
    all.count += part.count;
  }
  return all;
}

}  // namespace arris
