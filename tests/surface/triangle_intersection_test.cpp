// Single pairs whose answer is plain to see, and symmetry.
#include "surface/triangle_intersection.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <vector>

#include "tetra/predicates.h"

namespace arris {
namespace {

// Both orders of the two must agree.
bool meet(const std::vector<Vec3>& points, const Triangle& t, const Triangle& u) {
  const Facet f = make_facet(points, t), g = make_facet(points, u);
  const bool answer = facets_meet(f, g);
  EXPECT_EQ(facets_meet(g, f), answer);
  return answer;
}

// Points 0 1 2 span the triangle (0,0) (4,0) (0,4) at z = 0.
std::vector<Vec3> with(std::vector<Vec3> others) {
  others.insert(others.begin(), {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  return others;
}

TEST(TriangleIntersection, SharingNothing) {
  const Triangle t{0, 1, 2}, u{3, 4, 5};
  EXPECT_TRUE(meet(with({{1, 1, -1}, {1, 1, 1}, {9, 9, 1}}), t, u));     // a side pierces it
  EXPECT_TRUE(meet(with({{1, 1, 0}, {1, 1, 1}, {9, 9, 1}}), t, u));      // a corner inside
  EXPECT_TRUE(meet(with({{2, 2, 0}, {3, 3, 1}, {3, 3, -1}}), t, u));     // a corner on a side
  EXPECT_TRUE(meet(with({{4, 0, 0}, {5, 0, 1}, {5, 0, -1}}), t, u));     // corner on corner
  EXPECT_TRUE(meet(with({{-1, -1, 0}, {9, -1, 0}, {-1, 9, 0}}), t, u));  // coplanar, around it
  EXPECT_TRUE(meet(with({{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}), t, u));      // coplanar, inside it
  EXPECT_TRUE(meet(with({{4, 0, 0}, {8, 0, 0}, {8, 1, 0}}), t, u));      // coplanar, one point
  EXPECT_TRUE(meet(with({{-1, 0, 0}, {5, 0, 0}, {2, -1, 0}}), t, u));    // coplanar, along a side
  EXPECT_FALSE(meet(with({{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}), t, u));     // parallel
  EXPECT_FALSE(meet(with({{3, 3, 0}, {5, 3, 0}, {3, 5, 0}}), t, u));     // coplanar, apart
  EXPECT_FALSE(meet(with({{3, 3, -1}, {3, 3, 1}, {9, 9, 1}}), t, u));    // through the plane only
}

TEST(TriangleIntersection, SharingACorner) {
  const Triangle t{0, 1, 2}, u{0, 3, 4};
  EXPECT_TRUE(meet(with({{1, 1, 0}, {1, 1, 1}}), t, u));      // a side lies in it
  EXPECT_TRUE(meet(with({{2, 2, -1}, {2, 2, 1}}), t, u));     // cuts through
  EXPECT_TRUE(meet(with({{1, 0, 0}, {1, 0, 1}}), t, u));      // along a side
  EXPECT_TRUE(meet(with({{-1, 2, 0}, {2, -1, 0}}), t, u));    // coplanar, overlapping
  EXPECT_TRUE(meet(with({{8, 0, 0}, {8, -1, 0}}), t, u));     // coplanar, along a side
  EXPECT_FALSE(meet(with({{-1, 0, 0}, {0, -1, 0}}), t, u));   // coplanar, opposite: an X
  EXPECT_FALSE(meet(with({{-2, 3, 0}, {-2, -1, 0}}), t, u));  // coplanar, beside
  EXPECT_FALSE(meet(with({{1, 1, 1}, {2, 1, 1}}), t, u));     // above
  EXPECT_FALSE(meet(with({{-1, -1, 1}, {-1, -1, -1}}), t, u));
}

TEST(TriangleIntersection, SharingASide) {
  const Triangle t{0, 1, 2}, u{1, 0, 3};
  EXPECT_TRUE(meet(with({{1, 1, 0}}), t, u));    // folded flat
  EXPECT_TRUE(meet(with({{-9, 1, 0}}), t, u));   // folded flat, sideways
  EXPECT_FALSE(meet(with({{1, -1, 0}}), t, u));  // unfolded flat
  EXPECT_FALSE(meet(with({{1, 1, 1e-300}}), t, u));
}

TEST(TriangleIntersection, SameCornersAlwaysMeet) {
  EXPECT_TRUE(meet(with({}), {0, 1, 2}, {0, 1, 2}));
  EXPECT_TRUE(meet(with({}), {0, 1, 2}, {2, 1, 0}));
}

// Whatever the order of the corners and of the axes.
RC_GTEST_PROP(TriangleIntersection, DoesNotDependOnOrder, ()) {
  std::vector<Vec3> points(6);
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const auto coordinate = [&] { return double(random() % 4); };
  for (Vec3& p : points) p = {coordinate(), coordinate(), coordinate()};
  const Index shift = *rc::gen::inRange<Index>(0, 4);  // shares 3 - shift corners
  const Triangle t{0, 1, 2}, u{shift, shift + 1, shift + 2};
  RC_PRE(!collinear(points[0], points[1], points[2]));
  RC_PRE(!collinear(points[u[0]], points[u[1]], points[u[2]]));
  const bool answer = meet(points, t, u);
  RC_ASSERT(meet(points, {1, 0, 2}, {u[2], u[0], u[1]}) == answer);
  RC_ASSERT(meet(points, {2, 0, 1}, {u[2], u[1], u[0]}) == answer);
  std::vector<Vec3> turned;
  for (Vec3 p : points) turned.push_back({p.z, p.x, p.y});
  RC_ASSERT(meet(turned, t, u) == answer);
}

}  // namespace
}  // namespace arris
