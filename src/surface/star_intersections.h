// Pairs of triangles round one vertex that may meet where they should not.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arris/types.h"
#include "surface/oriented_tree.h"

namespace arris {

// Two triangles at v meet outside v if and only if the arcs meet in which they cut a small sphere
// round v: the ray from v through a point of both begins in both of them. So near triangles of a
// fan, all of which have v in their boxes, are told from far ones by their arcs.
class StarArcs {
 public:
  // Of `star`, triangles with the corner v. O(k log² k).
  StarArcs(std::span<const Vec3> points, std::span<const Triangle> triangles,
           std::span<const Index> star, Index v);

  // Replaces `partners` by the places in the star, above k, of all triangles that may meet the k-th
  // outside v; ascending. Too many, never too few.
  void partners_of(std::uint32_t k, std::vector<std::uint32_t>& partners) const;

 private:
  std::vector<std::uint32_t> owner_;       // per hull: place in the star
  std::vector<std::uint32_t> first_;       // hulls of place k: first_[k] .. first_[k + 1]
  std::vector<std::uint32_t> everywhere_;  // ascending: arcs of nearly half a turn, or unknown
  // Of triangles that hold the arcs, hulls; arcs of more than a right angle are cut in half.
  OrientedTree tree_;
};

}  // namespace arris
