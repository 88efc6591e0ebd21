#include "surface/box_tree.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"

namespace arris {
namespace {

// Subtrees of at most this many triangles are one task each.
constexpr std::size_t task_size = 16384;

}  // namespace

BoxTree::BoxTree(std::span<const Vec3> points, std::span<const Triangle> triangles,
                 std::vector<Index> selected, const Frame& frame, unsigned threads)
    : frame_(frame), triangle_(std::move(selected)) {
  std::size_t levels = 1;
  for (std::size_t n = size(); n > leaf_size; n -= n / 2) ++levels;
  nodes_.resize((std::size_t{1} << levels) - 1);
  boxes_.resize(size());
  std::vector<Item> items = make_items(points, triangles, threads);

  // The top of the tree one node after the other, then its subtrees side by side.
  std::vector<Range> top = {{0, 0, size()}}, tasks;
  for (std::size_t i = 0; i < top.size(); ++i) {
    const Range r = top[i];
    if (r.end - r.begin <= task_size) {
      tasks.push_back(r);
    } else {
      split(items, r);
      top.push_back(r.left());
      top.push_back(r.right());
    }
  }
  parallel_chunks(tasks.size(), 1, threads, [&](std::size_t task, std::size_t) {
    sort(items, tasks[task]);
    for (std::size_t i = tasks[task].begin; i < tasks[task].end; ++i) {
      triangle_[i] = items[i].triangle;
      for (Index v : triangles[triangle_[i]]) boxes_[i].add(map(points[v]));
    }
    fit(tasks[task]);
  });
  for (std::size_t i = top.size(); i-- > 0;) {  // children come after their parents
    const Range r = top[i];
    if (r.end - r.begin <= task_size) continue;
    nodes_[r.node].add(nodes_[r.left().node]);
    nodes_[r.node].add(nodes_[r.right().node]);
  }
}

std::vector<BoxTree::Item> BoxTree::make_items(std::span<const Vec3> points,
                                               std::span<const Triangle> triangles,
                                               unsigned threads) const {
  std::vector<Item> items(size());
  parallel_for(size(), threads, [&](std::size_t i) {
    Box box;
    for (Index v : triangles[triangle_[i]]) box.add(map(points[v]));
    for (std::size_t k = 0; k < 3; ++k) items[i].centre[k] = box.lo[k] / 2 + box.hi[k] / 2;
    items[i].triangle = triangle_[i];
  });
  return items;
}

// Puts the lower half by centre, along the longest axis of the centres, before the upper half.
void BoxTree::split(std::vector<Item>& items, Range r) {
  Box centres;
  for (std::size_t i = r.begin; i < r.end; ++i) centres.add(items[i].centre);
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (centres.hi[k] - centres.lo[k] > centres.hi[axis] - centres.lo[axis]) axis = k;
  const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(r.begin), at(r.middle()), at(r.end), [axis](const Item& a, const Item& b) {
    return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis]
                                            : a.triangle < b.triangle;
  });
}

void BoxTree::sort(std::vector<Item>& items, Range r) {
  if (r.end - r.begin <= leaf_size) return;
  split(items, r);
  sort(items, r.left());
  sort(items, r.right());
}

// Boxes of the nodes of a subtree from those of its triangles.
void BoxTree::fit(Range r) {
  Box& box = nodes_[r.node];
  if (r.end - r.begin <= leaf_size) {
    for (std::size_t i = r.begin; i < r.end; ++i) box.add(boxes_[i]);
  } else {
    fit(r.left());
    fit(r.right());
    box.add(nodes_[r.left().node]);
    box.add(nodes_[r.right().node]);
  }
}

}  // namespace arris
