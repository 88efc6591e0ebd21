// The search for intersections among triangles whose axis-parallel boxes overlap too many others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arris/types.h"
#include "base/job.h"
#include "surface/box_tree.h"
#include "surface/oriented_tree.h"
#include "surface/self_intersection.h"

namespace arris {

// The crowded triangles of a BoxTree, and the fans that they form. What one of them that comes
// first in the tree has to do with later ones, crowded or not.
class Crowd {
 public:
  // Holds on to points, triangles and tree. `positions`: of the crowded triangles, ascending.
  Crowd(std::span<const Vec3> points, std::span<const Triangle> triangles, const BoxTree& tree,
        std::vector<std::size_t> positions, std::size_t least_hub);

  // Adds the pairs of any triangle and a crowded one at a lower position, but for those with a
  // common hub. Uses `buffer`.
  void find_lower(std::size_t position, std::vector<std::uint32_t>& buffer,
                  Intersections& found) const;

  // The pairs with a common hub. In parallel; ticks the job, throws Failure(cancelled).
  Intersections find_round_hubs(Job& job, double from, double to) const;

 private:
  // The triangles of a hub, in the order of the tree.
  struct Fan {
    std::vector<Index> star;
    std::vector<std::uint8_t> crowded;
  };
  void find_hubs(std::size_t least_hub);
  void fill_fans();
  bool is_hub(Index v) const;
  LongTriangle make_long(Index triangle) const;
  Index lowest_common_hub(Index t, Index u) const;
  Intersections find_round(Index hub, const Fan& fan, Job& job) const;

  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  const BoxTree& boxes_;
  std::vector<std::size_t> positions_;
  std::vector<Index> hubs_;  // ascending
  std::vector<Fan> fans_;    // of each hub
  OrientedTree tree_;
};

// Adds what another part of the search has found.
void add(const Intersections& part, Intersections& all);

// Asks for one pair.
void test_pair(std::span<const Vec3> points, std::span<const Triangle> triangles, Index t, Index u,
               Intersections& found);

// Counts the pair, keeping the lowest as the example, in whatever order they come.
void add_pair(Index t, Index u, Defects& pairs);

}  // namespace arris
