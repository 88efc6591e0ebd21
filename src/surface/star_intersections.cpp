#include "surface/star_intersections.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/distinct.h"
#include "base/triangle.h"
#include "base/vec.h"

namespace arris {
namespace {

// Below this length, of the sum of two unit vectors, the middle of their arc is not known well.
constexpr double least_sum = 0x1p-10;
// Differences between these have directions that neither overflow nor lose digits by underflow.
constexpr double smallest = 1e-150, largest = 1e150;

// Unit vector from a to b, right to a few roundings: differences of coordinates are rounded but
// once. Nothing where it cannot be told.
std::optional<Vec3> direction(Vec3 a, Vec3 b) {
  const Vec3 d = b - a;
  const double size = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  if (!(size > smallest && size < largest)) return {};
  return normalized(d);
}

// The triangle between the ends of an arc of at most a right angle and where its tangents there
// meet: it holds the arc.
LongTriangle hull_of(Vec3 a, Vec3 b) {
  return {{a, b, 1 / (1 + dot(a, b)) * (a + b)}};
}

// One hull, or two, appended; false if the arc cannot be told.
bool add_hulls(Vec3 v, Vec3 p, Vec3 q, std::vector<LongTriangle>& hulls) {
  const auto a = direction(v, p), b = direction(v, q);
  if (!a || !b) return false;
  if (dot(*a, *b) >= 0) {
    hulls.push_back(hull_of(*a, *b));
    return true;
  }
  const Vec3 sum = *a + *b;
  const double size = length(sum);
  if (size < least_sum) return false;
  const Vec3 middle = 1 / size * sum;
  hulls.push_back(hull_of(*a, middle));
  hulls.push_back(hull_of(middle, *b));
  return true;
}

}  // namespace

StarArcs::StarArcs(std::span<const Vec3> points, std::span<const Triangle> triangles,
                   std::span<const Index> star, Index v)
    : first_{0}, tree_({}) {
  std::vector<LongTriangle> hulls;
  for (std::size_t k = 0; k < star.size(); ++k) {
    const Triangle& t = triangles[star[k]];
    if (!add_hulls(points[v], points[next_corner(t, v)], points[previous_corner(t, v)], hulls))
      everywhere_.push_back(static_cast<std::uint32_t>(k));
    owner_.resize(hulls.size(), static_cast<std::uint32_t>(k));
    first_.push_back(static_cast<std::uint32_t>(hulls.size()));
  }
  tree_ = OrientedTree(std::move(hulls));
}

void StarArcs::partners_of(std::uint32_t k, std::vector<std::uint32_t>& partners) const {
  partners.clear();
  const auto places = static_cast<std::uint32_t>(first_.size() - 1);
  if (first_[k] == first_[k + 1]) {  // everywhere
    for (std::uint32_t j = k + 1; j < places; ++j) partners.push_back(j);
    return;
  }
  for (std::uint32_t h = first_[k]; h < first_[k + 1]; ++h) tree_.find(tree_.member(h), partners);
  for (std::uint32_t& h : partners) h = owner_[h];
  partners.insert(partners.end(), everywhere_.begin(), everywhere_.end());
  std::erase_if(partners, [k](std::uint32_t j) { return j <= k; });
  keep_distinct(partners);
}

}  // namespace arris
