// A bounding volume hierarchy over the triangles of a mesh, in flat arrays.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "arris/types.h"
#include "surface/mesh_measure.h"

namespace arris {

// An axis-parallel box in the frame of a BoxTree.
struct Box {
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  std::array<float, 3> lo{infinity, infinity, infinity};
  std::array<float, 3> hi{-infinity, -infinity, -infinity};

  void add(const std::array<float, 3>& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = p[k] < lo[k] ? p[k] : lo[k];
      hi[k] = p[k] > hi[k] ? p[k] : hi[k];
    }
  }
  void add(const Box& box) {
    add(box.lo);
    add(box.hi);
  }
  bool overlaps(const Box& o) const {
    int apart = 0;  // no early exit: it would be mispredicted nearly always
    for (std::size_t k = 0; k < 3; ++k)
      apart |= static_cast<int>(lo[k] > o.hi[k]) | static_cast<int>(o.lo[k] > hi[k]);
    return apart == 0;
  }
  // A lower bound of the squared distance from `p` to what was rounded into this box.
  double squared_distance(Vec3 p) const {
    constexpr double rounding = 0x1p-23;  // of a float, generously
    const std::array<double, 3> q = {p.x, p.y, p.z};
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double l = static_cast<double>(lo[k]), h = static_cast<double>(hi[k]);
      const double below = l - rounding * std::abs(l) - q[k];
      const double above = q[k] - h - rounding * std::abs(h);
      const double gap = std::max({below, above, 0.0});
      sum += gap * gap;
    }
    return sum;
  }
};

// A balanced tree, split at the median centre along the longest axis, so that neither clusters nor
// outliers unbalance it. Boxes are floats: coordinates pass through a monotone map (scale, shift,
// round), which may make boxes meet that did not but never parts boxes that met. So a query may
// answer with too many triangles, never with too few.
class BoxTree {
 public:
  // Of the `selected` triangles; their vertices must be finite. `frame` affects speed alone: boxes
  // are finest near its origin. Complexity: O(n log n).
  BoxTree(std::span<const Vec3> points, std::span<const Triangle> triangles,
          std::vector<Index> selected, const Frame& frame, unsigned threads);

  // Triangles in tree order; the position in it is what queries answer with.
  std::size_t size() const noexcept { return triangle_.size(); }
  Index triangle(std::size_t position) const { return triangle_[position]; }
  const Box& box(std::size_t position) const { return boxes_[position]; }

  // A coordinate in the frame of the boxes.
  std::array<float, 3> map(Vec3 p) const noexcept {
    const Vec3 q = frame_.map(p);
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
  }

  const Frame& frame() const noexcept { return frame_; }

  // Calls visit(position), in ascending order, for every triangle at a position >= first whose box
  // overlaps `query`.
  template <class Visit>
  void for_each_overlap(const Box& query, std::size_t first, Visit&& visit) const {
    for_overlaps_while(query, first, [&](std::size_t position) {
      visit(position);
      return true;
    });
  }

  // The same until visit(position) returns false.
  template <class Visit>
  void for_overlaps_while(const Box& query, std::size_t first, Visit&& visit) const {
    if (boxes_.empty()) return;
    std::array<Range, 2 * max_depth> stack;
    std::size_t top = 0;
    stack[top++] = {0, 0, boxes_.size()};
    while (top > 0) {
      const Range r = stack[--top];
      if (r.end <= first || !nodes_[r.node].overlaps(query)) continue;
      if (r.end - r.begin <= leaf_size) {
        for (std::size_t i = r.begin > first ? r.begin : first; i < r.end; ++i)
          if (boxes_[i].overlaps(query) && !visit(i)) return;
      } else {
        stack[top++] = r.right();
        stack[top++] = r.left();
      }
    }
  }

  struct Nearest {
    std::size_t position = 0;
    double squared_distance = std::numeric_limits<double>::infinity();
  };

  // The position whose squared_distance(position), in the unit of the points, is the least; the
  // same for the same tree and query. `squared_distance` is asked only of triangles whose box
  // leaves them a chance. The tree must not be empty.
  template <class SquaredDistance>
  Nearest nearest(Vec3 p, SquaredDistance&& squared_distance) const {
    const Vec3 q = frame_.map(p);
    const double scale = frame_.scale * frame_.scale;
    struct Candidate {
      Range range;
      double bound;
    };
    std::array<Candidate, 2 * max_depth> stack;
    std::size_t top = 0;
    Nearest best;
    stack[top++] = {{0, 0, boxes_.size()}, 0};
    while (top > 0) {
      const auto [r, bound] = stack[--top];
      if (bound >= best.squared_distance * scale) continue;
      if (r.end - r.begin <= leaf_size) {
        for (std::size_t i = r.begin; i < r.end; ++i)
          if (const double d = squared_distance(i); d < best.squared_distance) best = {i, d};
        continue;
      }
      const Range left = r.left(), right = r.right();
      Candidate near{left, nodes_[left.node].squared_distance(q)};
      Candidate far{right, nodes_[right.node].squared_distance(q)};
      if (far.bound < near.bound) std::swap(near, far);
      stack[top++] = far;
      stack[top++] = near;
    }
    return best;
  }

 private:
  static constexpr std::size_t leaf_size = 4;
  static constexpr std::size_t max_depth = 64;

  // A node (children of i at 2i + 1 and 2i + 2) and the positions beneath it.
  struct Range {
    std::size_t node, begin, end;
    std::size_t middle() const { return begin + (end - begin) / 2; }
    Range left() const { return {2 * node + 1, begin, middle()}; }
    Range right() const { return {2 * node + 2, middle(), end}; }
  };
  struct Item {
    std::array<float, 3> centre;
    Index triangle;
  };

  std::vector<Item> make_items(std::span<const Vec3> points, std::span<const Triangle> triangles,
                               unsigned threads) const;
  static void split(std::vector<Item>& items, Range r);
  static void sort(std::vector<Item>& items, Range r);
  void fit(Range r);

  Frame frame_;
  std::vector<Index> triangle_;
  std::vector<Box> boxes_;  // of triangles
  std::vector<Box> nodes_;
};

}  // namespace arris
