// The nearest of many triangles, segments or points to any point.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "arris/types.h"
#include "surface/box_tree.h"

namespace arris::compare {

// Squared distance from p to the triangle abc, which may be degenerate: {a, b, b} is a segment,
// {a, a, a} a point.
double squared_distance_to_triangle(Vec3 p, const std::array<Vec3, 3>& corners);

// A tree over triangles whose corners are indices into `points` (finite). Copies what it needs.
class NearestElement {
 public:
  // Of the `selected` elements, not none. Complexity: O(n log n).
  NearestElement(std::span<const Vec3> points, std::span<const Triangle> elements,
                 std::vector<Index> selected, unsigned threads);

  struct Hit {
    Index element = no_index;  // index into `elements`
    double distance = 0;
  };
  // About O(log n) near the elements. Of several at the same distance, always the same one. Safe
  // to call from several threads.
  Hit operator()(Vec3 p) const;

  // Calls visit(element) for every element within `radius` of p.
  template <class Visit>
  void for_each_within(Vec3 p, double radius, Visit&& visit) const {
    Box box;
    box.add(tree_.map({p.x - radius, p.y - radius, p.z - radius}));
    box.add(tree_.map({p.x + radius, p.y + radius, p.z + radius}));
    tree_.for_each_overlap(box, 0, [&](std::size_t i) {
      if (squared_distance_to_triangle(p, corners_[i]) <= radius * radius) visit(tree_.triangle(i));
    });
  }

  // Calls visit(element) for every element whose box meets the line through p along `axis`.
  template <class Visit>
  void for_each_on_line(Vec3 p, std::size_t axis, Visit&& visit) const {
    Box box;
    box.add(tree_.map(p));
    box.lo[axis] = -Box::infinity;
    box.hi[axis] = Box::infinity;
    tree_.for_each_overlap(box, 0, [&](std::size_t i) { visit(tree_.triangle(i)); });
  }

 private:
  BoxTree tree_;
  std::vector<std::array<Vec3, 3>> corners_;  // in tree order: near ones lie together
};

}  // namespace arris::compare
