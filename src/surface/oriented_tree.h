// A hierarchy of oriented boxes over long triangles: needles side by side, and fans of them, whose
// axis-parallel boxes all overlap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "arris/types.h"

namespace arris {

// A triangle in a frame where coordinates are of the order of 1, as a query or as a member.
struct LongTriangle {
  std::array<Vec3, 3> corner;
  // Vertices of the mesh that it has and that are hubs, else no_index. What shares a hub is left
  // out of the answers: pairs round a hub are looked at there (star_intersections.h).
  std::array<Index, 3> hub{no_index, no_index, no_index};
};

bool share_hub(const std::array<Index, 3>& a, const std::array<Index, 3>& b) noexcept;

// Boxes along the mean long side and the mean normal of what they hold (as in Gottschalk, Lin,
// Manocha, "OBBTree", 1996), parted from a query along the axes of either; triangles round the same
// hub are kept together, so that a node of them can be left out as a whole. Answers with too many
// triangles, never with too few: what is parted in rounded arithmetic must be so by more than
// rounding can do.
class OrientedTree {
 public:
  // Complexity: O(n log² n) at most.
  explicit OrientedTree(std::vector<LongTriangle> triangles);

  const LongTriangle& member(std::uint32_t i) const noexcept { return triangles_[i]; }

  // Appends the numbers of the members that may meet the query and share no hub with it, in no
  // particular order.
  void find(const LongTriangle& query, std::vector<std::uint32_t>& found) const;

 private:
  struct OrientedBox {
    std::array<Vec3, 3> axis;  // orthonormal
    std::array<double, 3> lo, hi;
  };
  struct Node {
    OrientedBox box;
    std::uint32_t begin, end;  // members: order_[begin .. end)
    std::uint32_t right = 0;   // child; the left one comes next; 0: a leaf
    std::array<Index, 3> hub{no_index, no_index, no_index};  // those of all members
  };
  struct Probe;

  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  std::uint32_t split(std::uint32_t begin, std::uint32_t end);
  std::uint32_t split_groups(std::uint32_t begin, std::uint32_t end);
  OrientedBox box_of(std::uint32_t begin, std::uint32_t end) const;
  std::span<std::uint32_t> members(std::uint32_t begin, std::uint32_t end) {
    return std::span(order_).subspan(begin, end - begin);
  }

  std::vector<LongTriangle> triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace arris
