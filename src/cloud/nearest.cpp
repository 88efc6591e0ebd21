#include "cloud/nearest.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "base/vec.h"
#include "cloud/morton.h"

namespace arris {
namespace {

constexpr std::uint32_t leaf_size = 24;  // 8 to 32 measured: k = 17 is fastest, k = 1 no slower

// Single precision, rounded outward: two boxes fill a line of the cache.
struct Box {
  std::array<float, 3> low, high;

  // Never more than what is computed for a point in the box: rounding is monotone.
  double squared_distance(const std::array<double, 3>& q) const noexcept {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = std::max(std::max(double{low[k]} - q[k], q[k] - double{high[k]}), 0.0);
      sum += d * d;
    }
    return sum;
  }
};

float rounded_down(double x) {
  const auto f = static_cast<float>(x);
  return double{f} > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}

Box box_of(const Vec3 p) {
  return {{rounded_down(p.x), rounded_down(p.y), rounded_down(p.z)},
          {-rounded_down(-p.x), -rounded_down(-p.y), -rounded_down(-p.z)}};
}

void grow(Box& box, const Box& by) {
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min(box.low[k], by.low[k]);
    box.high[k] = std::max(box.high[k], by.high[k]);
  }
}

struct Node {
  Box box;
  std::uint32_t first = 0;  // of the points of a leaf, or of the two children
  std::uint32_t count = 0;  // of the points of a leaf; 0 for other nodes
};

struct Point {
  Vec3 position;
  Index index;
};

struct Keyed {
  std::uint64_t key;
  Index index;
};

bool nearer(const NearestSample::Hit& a, const NearestSample::Hit& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
}

// The `size` nearest so far, nearest first, with squared distances.
struct Found {
  NearestSample::Hit* hits;
  std::size_t size;

  double farthest() const noexcept { return hits[size - 1].distance; }
  void offer(Index index, double squared) noexcept {
    const NearestSample::Hit hit{index, squared};
    if (!nearer(hit, hits[size - 1])) return;
    std::size_t at = size - 1;
    for (; at > 0 && nearer(hit, hits[at - 1]); --at) hits[at] = hits[at - 1];
    hits[at] = hit;
  }
};

}  // namespace

// Points along the Morton curve, split where its cells are: a tree without a sort where the points
// come in that order, as samples do. With tight boxes it prunes on surfaces as a k-d tree does.
struct NearestSample::Tree {
  std::vector<Point> points;
  std::vector<Node> nodes;  // the root, then pairs of siblings

  explicit Tree(const std::vector<Vec3>& given) {
    std::vector<Keyed> keys(given.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
      keys[i] = {morton_key(given[i]), static_cast<Index>(i)};
    const auto before = [](const Keyed& a, const Keyed& b) {
      return a.key != b.key ? a.key < b.key : a.index < b.index;
    };
    if (!std::is_sorted(keys.begin(), keys.end(), before))
      std::sort(keys.begin(), keys.end(), before);
    points.reserve(keys.size());
    for (const Keyed& k : keys) points.push_back({given[k.index], k.index});
    nodes.reserve(keys.size() / 2);
    nodes.emplace_back();
    build(0, keys, 0, static_cast<std::uint32_t>(keys.size()));
  }

  void search(Vec3 query, Found& found) const;

 private:
  void build(std::uint32_t node, const std::vector<Keyed>& keys, std::uint32_t begin,
             std::uint32_t end);
  std::uint32_t split(const std::vector<Keyed>& keys, std::uint32_t begin, std::uint32_t end);
};

void NearestSample::Tree::build(std::uint32_t node, const std::vector<Keyed>& keys,
                                std::uint32_t begin, std::uint32_t end) {
  if (end - begin <= leaf_size) {
    Box box = box_of(points[begin].position);
    for (std::uint32_t k = begin + 1; k < end; ++k) grow(box, box_of(points[k].position));
    nodes[node] = {box, begin, end - begin};
    return;
  }
  const std::uint32_t middle = split(keys, begin, end);
  const auto children = static_cast<std::uint32_t>(nodes.size());
  nodes.resize(nodes.size() + 2);
  build(children, keys, begin, middle);
  build(children + 1, keys, middle, end);
  Box box = nodes[children].box;
  grow(box, nodes[children + 1].box);
  nodes[node] = {box, children, 0};
}

// Where the highest bit of the keys changes; the median along x, y or z, whichever spans most,
// within one cell of the curve.
std::uint32_t NearestSample::Tree::split(const std::vector<Keyed>& keys, std::uint32_t begin,
                                         std::uint32_t end) {
  const std::uint64_t low = keys[begin].key, high = keys[end - 1].key;
  const auto at = [](auto first, std::uint32_t k) { return first + std::ptrdiff_t{k}; };
  if (low != high) {
    const std::uint64_t bit = std::bit_floor(low ^ high);
    const auto middle =
        std::partition_point(at(keys.begin(), begin), at(keys.begin(), end),
                             [&](const Keyed& k) { return (k.key & bit) == (low & bit); });
    return static_cast<std::uint32_t>(middle - keys.begin());
  }
  Vec3 least = points[begin].position, most = least;
  for (std::uint32_t k = begin; k < end; ++k) {
    const Vec3 p = points[k].position;
    least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
  }
  const Vec3 span = most - least;
  const auto axis = span.x >= span.y && span.x >= span.z ? &Vec3::x
                    : span.y >= span.z                   ? &Vec3::y
                                                         : &Vec3::z;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(at(points.begin(), begin), at(points.begin(), middle), at(points.begin(), end),
                   [&](const Point& a, const Point& b) {
                     return a.position.*axis != b.position.*axis
                                ? a.position.*axis < b.position.*axis
                                : a.index < b.index;
                   });
  return middle;
}

void NearestSample::Tree::search(Vec3 query, Found& found) const {
  struct Task {
    std::uint32_t node;
    double distance;
  };
  constexpr std::size_t deepest = 128;  // 63 bits of the key and 32 halvings; one task a level
  std::array<Task, deepest> tasks;
  std::size_t waiting = 0;
  const std::array<double, 3> q = {query.x, query.y, query.z};
  Task task{0, 0};
  for (;;) {
    const Node& node = nodes[task.node];
    if (node.count == 0) {
      Task near{node.first, nodes[node.first].box.squared_distance(q)};
      Task far{node.first + 1, nodes[node.first + 1].box.squared_distance(q)};
      if (far.distance < near.distance) std::swap(near, far);
      if (far.distance <= found.farthest()) tasks[waiting++] = far;
      task = near;
      if (task.distance <= found.farthest()) continue;
    } else {
      for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
        found.offer(points[k].index, squared_length(query - points[k].position));
    }
    do {
      if (waiting == 0) return;
      task = tasks[--waiting];
    } while (task.distance > found.farthest());
  }
}

NearestSample::NearestSample(const std::vector<Vec3>& points)
    : tree_(std::make_unique<Tree>(points)) {}
NearestSample::~NearestSample() = default;

NearestSample::Hit NearestSample::operator()(Vec3 query) const {
  Hit hit{no_index, std::numeric_limits<double>::infinity()};
  Found found{&hit, 1};
  tree_->search(query, found);
  return {hit.index, std::sqrt(hit.distance)};
}

void NearestSample::nearest(Vec3 query, std::size_t k, std::vector<Hit>& hits) const {
  hits.assign(std::min(k, tree_->points.size()),
              {no_index, std::numeric_limits<double>::infinity()});
  if (hits.empty()) return;
  Found found{hits.data(), hits.size()};
  tree_->search(query, found);
  for (Hit& h : hits) h.distance = std::sqrt(h.distance);
  // Roots may be equal where the squares are not.
  if (!std::is_sorted(hits.begin(), hits.end(), nearer))
    std::sort(hits.begin(), hits.end(), nearer);
}

}  // namespace arris
