#include "compare/volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "compare/sampling.h"
#include "tetra/predicates.h"

namespace arris::compare {
namespace {

constexpr std::uint64_t stream = 200;  // of draws; each axis has its own
constexpr std::size_t lines_per_chunk = 64;

// A line through an edge or a vertex is drawn again, at most so often: one draw in 2^50 has to be.
constexpr int attempts = 16;

double coordinate(Vec3 p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

// Where a line along an axis passes the surface, and which way the surface faces there.
struct Crossing {
  double at;
  int facing;  // +1 along the axis
};

// Where the line through p meets the plane of the triangle, which is not parallel to it.
double crossing_of(Vec3 p, const std::array<Vec3, 3>& t, Vec3 normal, std::size_t axis) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  const auto slope = [&](std::size_t k) {
    return coordinate(normal, k) * (coordinate(p, k) - coordinate(t[0], k));
  };
  const double at = coordinate(t[0], axis) - (slope(i) + slope(j)) / coordinate(normal, axis);
  const auto [low, high] =
      std::minmax({coordinate(t[0], axis), coordinate(t[1], axis), coordinate(t[2], axis)});
  return at >= low && at <= high ? at
         : at > high             ? high
                                 : low;  // NaN: the plane is nearly parallel
}

// False if the line touches an edge or a vertex.
bool find_crossings(const Surface& surface, Vec3 p, std::size_t axis,
                    std::vector<Crossing>& crossings) {
  crossings.clear();
  bool clean = true;
  surface.tree->for_each_on_line(p, axis, [&](Index triangle) {
    const Triangle& t = surface.triangles[triangle];
    const std::array<Vec3, 3> c = {surface.points[t[0]], surface.points[t[1]],
                                   surface.points[t[2]]};
    const int along = static_cast<int>(axis);
    const int s0 = orient2d(c[0], c[1], p, along), s1 = orient2d(c[1], c[2], p, along);
    if (s0 * s1 < 0) return;
    const int s2 = orient2d(c[2], c[0], p, along);
    const int sum = s0 + s1 + s2;
    if (s1 * s2 < 0 || s0 * s2 < 0 || sum == 0) return;  // outside, or seen edge-on
    if (std::abs(sum) < 3)
      clean = false;
    else
      crossings.push_back({crossing_of(p, c, surface.normals[triangle], axis), sum > 0 ? 1 : -1});
  });
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return a.at != b.at ? a.at < b.at : a.facing < b.facing;
  });
  return clean;
}

// Walks along a line: is it inside?
class Walk {
 public:
  Walk(InsideRule rule) : rule_(rule) {}
  void cross(int facing) { depth_ = rule_ == InsideRule::parity ? 1 - depth_ : depth_ - facing; }
  bool inside() const { return depth_ != 0; }

 private:
  InsideRule rule_;
  int depth_ = 0;
};

// Lengths along lines that are inside both, and inside either.
struct Shared {
  double both = 0, either = 0;
};

void add_line(const std::vector<Crossing>& a, InsideRule rule_a, const std::vector<Crossing>& b,
              InsideRule rule_b, Shared& sums) {
  Walk in_a(rule_a), in_b(rule_b);
  double last = 0;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    const bool take_a = j == b.size() || (i < a.size() && a[i].at <= b[j].at);
    const Crossing& next = take_a ? a[i++] : b[j++];
    if (in_a.inside() && in_b.inside()) sums.both += next.at - last;
    if (in_a.inside() || in_b.inside()) sums.either += next.at - last;
    (take_a ? in_a : in_b).cross(next.facing);
    last = next.at;
  }
}

struct Bounds {
  Vec3 low, high;
};

Bounds bounds_of(const Surface& a, const Surface& b) {
  Bounds box{a.points[a.used[0]], a.points[a.used[0]]};
  for (const Surface* s : {&a, &b})
    for (const Index v : s->used) {
      const Vec3 p = s->points[v];
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
  return box;
}

// Lines along one axis through the cells of a grid across it.
class LineGrid {
 public:
  LineGrid(const Bounds& box, std::size_t axis, std::size_t lines)
      : low_{box.low.x, box.low.y, box.low.z}, axis_(axis) {
    const std::array<double, 3> high = {box.high.x, box.high.y, box.high.z};
    side_ = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(lines))));
    for (std::size_t k = 0; k < 3; ++k) cell_[k] = (high[k] - low_[k]) / static_cast<double>(side_);
  }
  std::size_t lines() const { return side_ * side_; }
  // The area that one line stands for.
  double weight() const { return cell_[(axis_ + 1) % 3] * cell_[(axis_ + 2) % 3]; }
  Vec3 place(std::size_t line, Draw& draw) const {
    std::array<double, 3> p = low_;
    const std::size_t i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
    p[i] += cell_[i] * (static_cast<double>(line % side_) + draw.unit());
    p[j] += cell_[j] * (static_cast<double>(line / side_) + draw.unit());
    return {p[0], p[1], p[2]};
  }

 private:
  std::array<double, 3> low_, cell_{};
  std::size_t axis_, side_ = 1;
};

Shared along_axis(const Solid& a, const Solid& b, const LineGrid& grid, std::size_t axis,
                  std::uint64_t seed, Job& job) {
  const std::size_t n = grid.lines();
  std::vector<Shared> chunks((n + lines_per_chunk - 1) / lines_per_chunk);
  const double from = static_cast<double>(axis) / 3, to = static_cast<double>(axis + 1) / 3;
  for_chunks(job, n, lines_per_chunk, from, to, [&](std::size_t begin, std::size_t end) {
    std::vector<Crossing> of_a, of_b;
    for (std::size_t line = begin; line < end && !job.cancelled(); ++line) {
      Draw draw(seed, stream + axis, line);
      for (int attempt = 0; attempt < attempts; ++attempt) {
        const Vec3 p = grid.place(line, draw);
        if (!find_crossings(a.surface, p, axis, of_a) || !find_crossings(b.surface, p, axis, of_b))
          continue;
        add_line(of_a, a.rule, of_b, b.rule, chunks[begin / lines_per_chunk]);
        break;
      }
    }
  });
  Shared sum;
  for (const Shared& chunk : chunks) sum.both += chunk.both, sum.either += chunk.either;
  return {sum.both * grid.weight(), sum.either * grid.weight()};
}

}  // namespace

double volume_iou(const Solid& result, const Solid& truth, const CompareOptions& options,
                  Job& job) {
  const Bounds box = bounds_of(result.surface, truth.surface);
  Shared sum;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const LineGrid grid(box, axis, options.samples / 3 + 1);
    const Shared s = along_axis(result, truth, grid, axis, options.seed, job);
    sum.both += s.both;
    sum.either += s.either;
  }
  return sum.either > 0 ? sum.both / sum.either : undefined;
}

}  // namespace arris::compare
