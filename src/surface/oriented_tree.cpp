#include "surface/oriented_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/vec.h"

namespace arris {
namespace {

constexpr std::uint32_t leaf_size = 4;
// Intervals farther apart than this do not meet: a hundred times what the rounding of coordinates
// and products, all of the order of 1, amounts to.
constexpr double clearance = 0x1p-40;
// A normal this near to the long side, as a sine, gives no second axis.
constexpr double least_sine = 1e-3;

Vec3 centre(const LongTriangle& t) {
  return 1.0 / 3 * (t.corner[0] + t.corner[1] + t.corner[2]);
}

Vec3 longest_side(const LongTriangle& t) {
  Vec3 longest;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 side = t.corner[(k + 1) % 3] - t.corner[k];
    if (squared_length(side) > squared_length(longest)) longest = side;
  }
  return longest;
}

Vec3 normal_of(const LongTriangle& t) {
  return cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]);
}

double component(Vec3 p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

// Any unit vector at right angles to the unit vector a.
Vec3 across(Vec3 a) {
  const double x = std::abs(a.x), y = std::abs(a.y), z = std::abs(a.z);
  return normalized(cross(a, x <= y && x <= z ? Vec3{1, 0, 0}
                             : y <= z         ? Vec3{0, 1, 0}
                                              : Vec3{0, 0, 1}));
}

// Sums of lines, not of directions: each is taken the way the first goes.
void add_line(Vec3& sum, Vec3 v) {
  sum = dot(sum, v) < 0 ? sum - v : sum + v;
}

// The axis along which points spread most.
template <class Points>
std::size_t widest_axis(const Points& points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> lo, hi;
  lo.fill(infinity);
  hi.fill(-infinity);
  for (Vec3 p : points)
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], component(p, k));
      hi[k] = std::max(hi[k], component(p, k));
    }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
  return axis;
}

// The hub by which a triangle is grouped; no_index, the highest, if it has none.
Index group_of(const LongTriangle& t) {
  return std::min({t.hub[0], t.hub[1], t.hub[2]});
}

std::array<Index, 3> common_hubs(const std::array<Index, 3>& a, const std::array<Index, 3>& b) {
  std::array<Index, 3> both = a;
  for (Index& h : both)
    if (std::find(b.begin(), b.end(), h) == b.end()) h = no_index;
  return both;
}

}  // namespace

bool share_hub(const std::array<Index, 3>& a, const std::array<Index, 3>& b) noexcept {
  for (Index h : a)
    if (h != no_index && (h == b[0] || h == b[1] || h == b[2])) return true;
  return false;
}

// A query with its own axes, the normal and those across its sides in its plane, and where it lies
// along them.
struct OrientedTree::Probe {
  explicit Probe(const LongTriangle& t) : corner(t.corner) {
    axis[0] = normalized(normal_of(t));
    for (std::size_t k = 0; k < 3; ++k)
      axis[k + 1] = normalized(cross(axis[0], t.corner[(k + 1) % 3] - t.corner[k]));
    for (std::size_t a = 0; a < axis.size(); ++a) {
      const std::array<double, 3> x = along(axis[a]);
      lo[a] = *std::min_element(x.begin(), x.end()) - clearance;
      hi[a] = *std::max_element(x.begin(), x.end()) + clearance;
    }
  }

  std::array<double, 3> along(Vec3 a) const {
    return {dot(a, corner[0]), dot(a, corner[1]), dot(a, corner[2])};
  }

  bool is_parted_from(const OrientedBox& box) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [x, y, z] = along(box.axis[k]);
      if (std::min({x, y, z}) > box.hi[k] + clearance ||
          std::max({x, y, z}) < box.lo[k] - clearance)
        return true;
    }
    for (std::size_t a = 0; a < axis.size(); ++a) {
      double middle = 0, half = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double c = dot(axis[a], box.axis[k]);
        middle += 0.5 * (box.lo[k] + box.hi[k]) * c;
        half += 0.5 * (box.hi[k] - box.lo[k]) * std::abs(c);
      }
      if (middle - half > hi[a] || middle + half < lo[a]) return true;
    }
    return false;
  }

  const std::array<Vec3, 3>& corner;
  std::array<Vec3, 4> axis;  // unit; null ones part nothing
  std::array<double, 4> lo, hi;
};

OrientedTree::OrientedTree(std::vector<LongTriangle> triangles)
    : triangles_(std::move(triangles)), order_(triangles_.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

std::uint32_t OrientedTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto id = static_cast<std::uint32_t>(nodes_.size());
  Node node;
  node.box = box_of(begin, end);
  node.begin = begin;
  node.end = end;
  node.hub = triangles_[order_[begin]].hub;
  for (std::uint32_t t : members(begin, end)) node.hub = common_hubs(node.hub, triangles_[t].hub);
  nodes_.push_back(node);
  if (end - begin <= leaf_size) return id;
  const std::uint32_t middle = split(begin, end);
  build(begin, middle);
  const std::uint32_t right = build(middle, end);
  nodes_[id].right = right;
  return id;
}

// Groups first; within a group at the median along the widest axis.
std::uint32_t OrientedTree::split(std::uint32_t begin, std::uint32_t end) {
  const auto range = members(begin, end);
  const Index group = group_of(triangles_[range[0]]);
  for (std::uint32_t t : range)
    if (group_of(triangles_[t]) != group) return split_groups(begin, end);
  std::vector<Vec3> centres;
  centres.reserve(range.size());
  for (std::uint32_t t : range) centres.push_back(centre(triangles_[t]));
  const std::size_t axis = widest_axis(centres);
  const auto at = [&](std::uint32_t t) { return component(centre(triangles_[t]), axis); };
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(range.begin(), range.begin() + (middle - begin), range.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double x = at(a), y = at(b);
                     return x != y ? x < y : a < b;
                   });
  return middle;
}

// In the order of their mean centres along the widest axis, where the halves differ least.
std::uint32_t OrientedTree::split_groups(std::uint32_t begin, std::uint32_t end) {
  const auto range = members(begin, end);
  const auto group = [&](std::uint32_t t) { return group_of(triangles_[t]); };
  std::sort(range.begin(), range.end(), [&](std::uint32_t a, std::uint32_t b) {
    return group(a) != group(b) ? group(a) < group(b) : a < b;
  });
  struct Run {
    std::size_t begin, end;
  };
  std::vector<Run> runs;
  std::vector<Vec3> means;
  for (std::size_t k = 0; k < range.size();) {
    Run run{k, k};
    Vec3 sum;
    while (run.end < range.size() && group(range[run.end]) == group(range[k]))
      sum = sum + centre(triangles_[range[run.end++]]);
    runs.push_back(run);
    means.push_back(1 / static_cast<double>(run.end - run.begin) * sum);
    k = run.end;
  }
  const std::size_t axis = widest_axis(means);
  std::vector<std::size_t> by_mean(runs.size());
  std::iota(by_mean.begin(), by_mean.end(), std::size_t{0});
  std::stable_sort(by_mean.begin(), by_mean.end(), [&](std::size_t a, std::size_t b) {
    return component(means[a], axis) < component(means[b], axis);
  });
  const std::vector<std::uint32_t> before(range.begin(), range.end());
  std::size_t placed = 0, middle = 0;
  const auto unevenness = [&](std::size_t k) {
    return std::max(k, range.size() - k) - std::min(k, range.size() - k);
  };
  for (std::size_t r : by_mean) {
    if (middle == 0 || unevenness(placed) < unevenness(middle)) middle = placed;
    for (std::size_t k = runs[r].begin; k < runs[r].end; ++k) range[placed++] = before[k];
  }
  return begin + static_cast<std::uint32_t>(middle);
}

OrientedTree::OrientedBox OrientedTree::box_of(std::uint32_t begin, std::uint32_t end) const {
  const auto range = std::span(order_).subspan(begin, end - begin);
  Vec3 side, normal;
  for (std::uint32_t t : range) {
    add_line(side, longest_side(triangles_[t]));
    add_line(normal, normal_of(triangles_[t]));
  }
  OrientedBox box;
  box.axis[0] = normalized(side);
  if (box.axis[0] == Vec3{}) box.axis[0] = {1, 0, 0};
  const auto upright = [&](Vec3 a) { return a - dot(a, box.axis[0]) * box.axis[0]; };
  const Vec3 second = upright(normalized(normal));
  // Twice is enough for a right angle to the last bits.
  box.axis[1] =
      length(second) > least_sine ? normalized(upright(normalized(second))) : across(box.axis[0]);
  box.axis[2] = cross(box.axis[0], box.axis[1]);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  box.lo.fill(infinity);
  box.hi.fill(-infinity);
  for (std::uint32_t t : range)
    for (Vec3 p : triangles_[t].corner)
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = dot(box.axis[k], p);
        box.lo[k] = std::min(box.lo[k], x);
        box.hi[k] = std::max(box.hi[k], x);
      }
  return box;
}

void OrientedTree::find(const LongTriangle& query, std::vector<std::uint32_t>& found) const {
  if (nodes_.empty()) return;
  const Probe probe(query);
  std::vector<std::uint32_t> stack = {0};
  while (!stack.empty()) {
    const std::uint32_t id = stack.back();
    const Node& node = nodes_[id];
    stack.pop_back();
    if (share_hub(node.hub, query.hub) || probe.is_parted_from(node.box)) continue;
    if (node.right != 0) {
      stack.push_back(node.right);
      stack.push_back(id + 1);
      continue;
    }
    for (std::uint32_t k = node.begin; k < node.end; ++k)
      if (!share_hub(triangles_[order_[k]].hub, query.hub)) found.push_back(order_[k]);
  }
}

}  // namespace arris
