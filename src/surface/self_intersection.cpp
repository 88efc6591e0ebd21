#include "surface/self_intersection.h"

#include <algorithm>
#include <vector>

#include "base/failure.h"
#include "base/parallel.h"
#include "surface/crowd.h"
#include "surface/triangle_intersection.h"

namespace arris {
namespace {

constexpr std::size_t positions_per_chunk = 1024;
constexpr std::size_t positions_per_query = 8;
constexpr std::size_t positions_per_tick = 64 * positions_per_chunk;

// What one chunk of positions comes to.
struct Part {
  Intersections found;
  std::vector<std::size_t> crowded;
};

// Finds the pairs of a run of positions with all later positions.
class PairFinder {
 public:
  PairFinder(std::span<const Vec3> points, std::span<const Triangle> triangles, const BoxTree& tree,
             std::size_t most_near)
      : points_(points), triangles_(triangles), tree_(tree), most_near_(most_near) {}

  // Positions [begin, end), few and near each other, ask the tree one question together; one by one
  // if the answer is too long for that. Single ones with too long an answer are left for later.
  void find(std::size_t begin, std::size_t end, Part& part) {
    if (look_round(begin, end)) {
      for (std::size_t i = begin; i < end; ++i) test(i, i - begin, part);
      return;
    }
    for (std::size_t i = begin; i < end; ++i) {
      if (look_round(i, i + 1))
        test(i, 0, part);
      else
        part.crowded.push_back(i);
    }
  }

 private:
  struct Near {
    Box box;
    std::size_t position;
    Facet facet;
  };

  // Fills near_; false if it would be too long.
  bool look_round(std::size_t begin, std::size_t end) {
    Box query;
    for (std::size_t i = begin; i < end; ++i) query.add(tree_.box(i));
    positions_.clear();
    const std::size_t most = most_near_ + (end - begin);
    tree_.for_overlaps_while(query, begin, [&](std::size_t j) {
      positions_.push_back(j);
      return positions_.size() <= most;
    });
    if (positions_.size() > most) return false;
    near_.clear();
    for (std::size_t j : positions_)
      near_.push_back({tree_.box(j), j, make_facet(points_, triangles_[tree_.triangle(j)])});
    return true;
  }

  // Position i is at `place` of near_: positions come in ascending order.
  void test(std::size_t i, std::size_t place, Part& part) {
    const Near& own = near_[place];
    for (std::size_t k = place + 1; k < near_.size(); ++k) {
      if (!near_[k].box.overlaps(own.box)) continue;
      ++part.found.tested;
      if (facets_meet(own.facet, near_[k].facet))
        add_pair(tree_.triangle(i), tree_.triangle(near_[k].position), part.found.pairs);
    }
  }

  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  const BoxTree& tree_;
  std::size_t most_near_;
  std::vector<std::size_t> positions_;
  std::vector<Near> near_;
};

// body(begin, end, part) for chunks of all positions, in parallel; ticks the job meanwhile.
template <class Body>
void for_positions(std::size_t n, Job& job, double from, double to, std::vector<Part>& parts,
                   Body&& body) {
  parts.resize((n + positions_per_chunk - 1) / positions_per_chunk);
  for (std::size_t start = 0; start < n; start += positions_per_tick) {
    job.tick(from + (to - from) * static_cast<double>(start) / static_cast<double>(n));
    parallel_chunks(std::min(positions_per_tick, n - start), positions_per_chunk, job.threads(),
                    [&](std::size_t begin, std::size_t end) {
                      body(start + begin, start + end,
                           parts[(start + begin) / positions_per_chunk]);
                    });
  }
  job.tick(to);
}

Intersections find_in_crowd(const Crowd& crowd, std::size_t n, Job& job, double from) {
  const double middle = 0.5 * (from + 1);
  std::vector<Part> parts;
  for_positions(n, job, from, middle, parts, [&](std::size_t begin, std::size_t end, Part& part) {
    std::vector<std::uint32_t> buffer;
    for (std::size_t i = begin; i < end; ++i) {
      if (job.cancelled()) return;  // the next tick throws
      crowd.find_lower(i, buffer, part.found);
    }
  });
  Intersections all = crowd.find_round_hubs(job, middle, 1);
  for (const Part& part : parts) add(part.found, all);
  return all;
}

}  // namespace

Intersections find_intersections(std::span<const Vec3> points, std::span<const Triangle> triangles,
                                 const BoxTree& tree, Job& job, double from,
                                 const CrowdLimits& limits) {
  const std::size_t n = tree.size();
  std::vector<Part> parts;
  for_positions(n, job, from, 1, parts, [&](std::size_t begin, std::size_t end, Part& part) {
    PairFinder finder(points, triangles, tree, limits.most_near);
    for (std::size_t i = begin; i < end; i += positions_per_query) {
      if (job.cancelled()) return;  // the next tick throws
      finder.find(i, std::min(i + positions_per_query, end), part);
    }
  });
  Intersections all;
  std::vector<std::size_t> crowded;
  for (const Part& part : parts) {
    add(part.found, all);
    crowded.insert(crowded.end(), part.crowded.begin(), part.crowded.end());
  }
  if (!crowded.empty())
    add(find_in_crowd(Crowd(points, triangles, tree, std::move(crowded), limits.least_hub), n, job,
                      1),
        all);
  job.tick(1);
  return all;
}

}  // namespace arris
