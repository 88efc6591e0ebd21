#include "compare/nearest.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "base/vec.h"

namespace arris::compare {
namespace {

double squared_distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 ab = b - a, ap = p - a;
  const double whole = squared_length(ab);
  const double at = whole > 0 ? std::clamp(dot(ap, ab) / whole, 0.0, 1.0) : 0;
  return squared_length(ap - at * ab);
}

}  // namespace

double squared_distance_to_triangle(Vec3 p, const std::array<Vec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vec3 normal = cross(b - a, c - a);
  const double squared_normal = squared_length(normal);
  const auto left_of = [&](Vec3 from, Vec3 to) {
    return dot(cross(to - from, p - from), normal) >= 0;
  };
  if (squared_normal > 0 && left_of(a, b) && left_of(b, c) && left_of(c, a)) {
    const double height = dot(p - a, normal);
    return height * height / squared_normal;
  }
  return std::min({squared_distance_to_segment(p, a, b), squared_distance_to_segment(p, b, c),
                   squared_distance_to_segment(p, c, a)});
}

NearestElement::NearestElement(std::span<const Vec3> points, std::span<const Triangle> elements,
                               std::vector<Index> selected, unsigned threads)
    : tree_(points, elements, std::move(selected), measuring_frame(points), threads),
      corners_(tree_.size()) {
  parallel_for(tree_.size(), threads, [&](std::size_t i) {
    const Triangle& t = elements[tree_.triangle(i)];
    corners_[i] = {points[t[0]], points[t[1]], points[t[2]]};
  });
}

NearestElement::Hit NearestElement::operator()(Vec3 p) const {
  const BoxTree::Nearest best =
      tree_.nearest(p, [&](std::size_t i) { return squared_distance_to_triangle(p, corners_[i]); });
  return {tree_.triangle(best.position), std::sqrt(best.squared_distance)};
}

}  // namespace arris::compare
