// The tree of nearest elements against trying all of them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "base/vec.h"
#include "compare/nearest.h"
#include "support/measure.h"
#include "support/random.h"

namespace arris::test {
namespace {

using compare::NearestElement;

constexpr int grid = 4;  // few coordinates: many degenerate and equal elements

struct Elements {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

// Triangles, segments and points, half of them on a coarse grid.
Elements random_elements(std::uint64_t seed, std::size_t n) {
  Random random(seed);
  Elements e;
  for (std::size_t i = 0; i < n + 2; ++i) {
    const bool coarse = random.below(2) == 0;
    const auto c = [&] {
      return coarse ? static_cast<double>(random.below(grid)) : 3 * random.unit();
    };
    const double x = c(), y = c(), z = c();
    e.points.push_back({x, y, z});
  }
  const auto any = [&] { return static_cast<Index>(random.below(e.points.size())); };
  for (std::size_t i = 0; i < n; ++i) {
    const Index a = any(), b = any(), c = any();
    e.triangles.push_back(i % 3 == 0   ? Triangle{a, a, a}
                          : i % 3 == 1 ? Triangle{a, b, b}
                                       : Triangle{a, b, c});
  }
  return e;
}

std::vector<Index> all_of(const Elements& e) {
  std::vector<Index> all(e.triangles.size());
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

// The oracle takes a triangle on one line for its three sides.
double distance_to(Vec3 p, const Elements& e, Index t) {
  const Vec3 a = e.points[e.triangles[t][0]], b = e.points[e.triangles[t][1]],
             c = e.points[e.triangles[t][2]];
  if (length(cross(b - a, c - a)) > 0) return distance_to_triangle(p, a, b, c);
  return std::min({distance_to_triangle(p, a, b, b), distance_to_triangle(p, b, c, c),
                   distance_to_triangle(p, c, a, a)});
}

RC_GTEST_PROP(NearestElement, IsTheNearestOfAll, (std::uint64_t seed)) {
  const Elements e = random_elements(seed, 1 + seed % 200);
  const NearestElement tree(e.points, e.triangles, all_of(e), 1);
  Random random(seed + 1);
  for (int i = 0; i < 50; ++i) {
    const Vec3 p{5 * random.unit() - 1, 5 * random.unit() - 1, 5 * random.unit() - 1};
    double best = 1e300;
    for (Index t = 0; t < e.triangles.size(); ++t) best = std::min(best, distance_to(p, e, t));
    const NearestElement::Hit hit = tree(p);
    RC_ASSERT(std::abs(hit.distance - best) < 1e-9);
    RC_ASSERT(std::abs(distance_to(p, e, hit.element) - best) < 1e-9);
  }
}

RC_GTEST_PROP(NearestElement, FindsAllWithinARadius, (std::uint64_t seed)) {
  const Elements e = random_elements(seed, 1 + seed % 100);
  const NearestElement tree(e.points, e.triangles, all_of(e), 1);
  Random random(seed + 1);
  const Vec3 p{3 * random.unit(), 3 * random.unit(), 3 * random.unit()};
  const double radius = random.unit();
  std::set<Index> found, expected;
  tree.for_each_within(p, radius, [&](Index t) { RC_ASSERT(found.insert(t).second); });
  for (Index t = 0; t < e.triangles.size(); ++t)
    if (distance_to(p, e, t) <= radius) expected.insert(t);
  RC_ASSERT(found == expected);
}

TEST(NearestElement, DoesNotMissWhatRoundsAway) {
  // Two points that are one in single precision, far from the origin of the frame.
  const std::vector<Vec3> points = {{1, 0, 0}, {1 + 1e-12, 0, 0}, {-1, 0, 0}};
  const std::vector<Triangle> elements = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  const NearestElement tree(points, elements, {0, 1, 2}, 1);
  EXPECT_EQ(tree({1, 0, 0}).element, 0u);
  EXPECT_EQ(tree({1 + 1e-12, 0, 0}).element, 1u);
  EXPECT_EQ(tree({-3, 0, 0}).element, 2u);
}

}  // namespace
}  // namespace arris::test
