#include "surface/self_intersection.h"

#include <algorithm>
#include <vector>

#include "base/failure.h"
#include "base/parallel.h"
#include "surface/triangle_intersection.h"

namespace arris {
namespace {

constexpr std::size_t positions_per_chunk = 1024;
constexpr std::size_t positions_per_query = 8;
constexpr std::size_t positions_per_tick = 64 * positions_per_chunk;

// Adds the pair, keeping the lowest as the example, in whatever order they come.
void add_pair(Defects& pairs, Index t, Index u) {
  const std::array<Index, 3> pair = {std::min(t, u), std::max(t, u), no_index};
  pairs.example = pairs.count++ == 0 ? pair : std::min(pairs.example, pair);
}

// Finds the pairs of a run of positions with all later positions.
class PairFinder {
 public:
  PairFinder(std::span<const Vec3> points, std::span<const Triangle> triangles, const BoxTree& tree)
      : points_(points), triangles_(triangles), tree_(tree) {}

  // Positions [begin, end), few and near each other, ask the tree one question together.
  void find(std::size_t begin, std::size_t end, Defects& pairs) {
    Box query;
    for (std::size_t i = begin; i < end; ++i) query.add(tree_.box(i));
    near_.clear();
    tree_.for_each_overlap(query, begin, [&](std::size_t j) {
      near_.push_back({tree_.box(j), j, make_facet(points_, triangles_[tree_.triangle(j)])});
    });
    for (std::size_t i = begin; i < end; ++i) {
      const Near& own = near_[i - begin];  // positions come in ascending order
      for (std::size_t k = i - begin + 1; k < near_.size(); ++k)
        if (near_[k].box.overlaps(own.box) && facets_meet(own.facet, near_[k].facet))
          add_pair(pairs, tree_.triangle(i), tree_.triangle(near_[k].position));
    }
  }

 private:
  struct Near {
    Box box;
    std::size_t position;
    Facet facet;
  };
  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  const BoxTree& tree_;
  std::vector<Near> near_;
};

}  // namespace

Defects find_intersections(std::span<const Vec3> points, std::span<const Triangle> triangles,
                           const BoxTree& tree, Job& job, double from) {
  std::vector<Defects> parts((tree.size() + positions_per_chunk - 1) / positions_per_chunk);
  for (std::size_t start = 0; start < tree.size(); start += positions_per_tick) {
    job.tick(from + (1 - from) * static_cast<double>(start) / static_cast<double>(tree.size()));
    const std::size_t n = std::min(positions_per_tick, tree.size() - start);
    parallel_chunks(n, positions_per_chunk, job.threads(), [&](std::size_t begin, std::size_t end) {
      Defects& pairs = parts[(start + begin) / positions_per_chunk];
      PairFinder finder(points, triangles, tree);
      for (std::size_t i = start + begin; i < start + end; i += positions_per_query) {
        if (job.cancelled()) return;  // the next tick throws
        finder.find(i, std::min(i + positions_per_query, start + end), pairs);
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
