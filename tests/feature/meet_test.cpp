#include "feature/meet.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "support/random.h"

namespace arris {
namespace {

using namespace test;

constexpr double least_sine = 0.1;

// A plane through a point near the origin.
LocalSurface random_plane(Random& random) {
  return tangent_plane(0.5 * random.direction(), random.direction());
}

// A paraboloid or a saddle whose radii of curvature are five and more.
LocalSurface random_quadric(Random& random) {
  LocalSurface s = random_plane(random);
  s.c = {0.1 * random.normal(), 0, 0, 0, 0, 0};
  for (std::size_t k = 3; k < 6; ++k) s.c[k] = random.between(-0.1, 0.1);
  return s;
}

double sine(const LocalSurface& a, const LocalSurface& b) {
  return length(cross(a.n, b.n));
}

RC_GTEST_PROP(Meet, TwoPlanesMeetAtTheFootOfTheStart, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const LocalSurface a = random_plane(random), b = random_plane(random);
  RC_PRE(sine(a, b) > 2 * least_sine);
  const Vec3 start = random.direction();
  const auto x = meet(a, b, start, least_sine);
  RC_ASSERT(x.has_value());
  RC_ASSERT(std::abs(a.distance(*x)) < 1e-12 && std::abs(b.distance(*x)) < 1e-12);
  RC_ASSERT(std::abs(dot(*x - start, cross(a.n, b.n))) < 1e-12);
}

RC_GTEST_PROP(Meet, ThreePlanesMeetInOnePoint, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const LocalSurface a = random_plane(random), b = random_plane(random), c = random_plane(random);
  RC_PRE(std::abs(dot(a.n, cross(b.n, c.n))) > 0.1);
  const auto x = meet(a, b, c, random.direction());
  RC_ASSERT(x.has_value());
  for (const LocalSurface* s : {&a, &b, &c}) RC_ASSERT(std::abs(s->distance(*x)) < 1e-11);
  const auto same = meet(c, a, b, random.direction());
  RC_ASSERT(same.has_value());
  RC_ASSERT(distance(*x, *same) < 1e-10);
}

RC_GTEST_PROP(Meet, AQuadricMeetsAPlaneOnBoth, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  LocalSurface a = random_quadric(random), b = random_plane(random);
  a.origin = b.origin = {};
  RC_PRE(sine(a, b) > 0.5);
  const Vec3 start = 0.5 * random.direction();
  const auto x = meet(a, b, start, least_sine);
  RC_ASSERT(x.has_value());
  // Six steps end there: distances are of the first order, so the last digits come slowly.
  RC_PRE(distance(*x, start) < 1.5);
  RC_ASSERT(std::abs(a.distance(*x)) < 1e-6 && std::abs(b.distance(*x)) < 1e-6);
}

// z = 0 and the cylinder of radius 5 about the y axis, sunk by h: to second order.
TEST(Meet, APlaneCutsACylinderInItsLines) {
  LocalSurface cylinder = tangent_plane({0, 0, 0.1}, {0, 0, 1});
  const double k = 1.0 / 5;
  // The frame's own axes may lie anywhere in the plane.
  const double ux = cylinder.u.x, vx = cylinder.v.x;
  cylinder.c = {0, 0, 0, -k / 2 * ux * ux, -k * ux * vx, -k / 2 * vx * vx};
  const LocalSurface plane = tangent_plane({}, {0, 0, 1});
  for (double side : {1.0, -1.0}) {
    const auto x = meet(cylinder, plane, {side * 1.2, 0.7, 0.1}, 0.01);
    ASSERT_TRUE(x);
    EXPECT_NEAR(x->x, side, 1e-9);  // 0.1 = x² / 10
    EXPECT_NEAR(x->y, 0.7, 1e-9);   // across the line
    EXPECT_NEAR(x->z, 0, 1e-9);
  }
}

TEST(Meet, ParallelPlanesDoNot) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const LocalSurface a = random_plane(random), other = random_plane(random);
    LocalSurface b = a;
    b.origin = b.origin + 0.3 * b.n;
    EXPECT_FALSE(meet(a, b, {}, least_sine));
    EXPECT_FALSE(meet(a, a, {}, least_sine));
    EXPECT_FALSE(meet(a, b, other, {}));
    b.n = -b.n;
    b.v = -b.v;
    EXPECT_FALSE(meet(a, b, {}, least_sine));
  }
}

TEST(Meet, TheAngleAskedForDecides) {
  for (double angle : {0.05, 0.09, 0.11, 0.2}) {
    const LocalSurface a = tangent_plane({}, {0, 0, 1});
    const LocalSurface b = tangent_plane({}, {0, std::sin(angle), std::cos(angle)});
    EXPECT_EQ(meet(a, b, {1, 0.1, 0.1}, least_sine).has_value(), angle > 0.1) << angle;
  }
}

// The faces of a prism have a direction in common.
TEST(Meet, ThreeFacesOfAPrismHaveNoCorner) {
  const LocalSurface a = tangent_plane({0, 0, 0}, {1, 0, 0});
  const LocalSurface b = tangent_plane({0, 0, 0}, {0, 1, 0});
  const double half = std::sqrt(0.5);
  const LocalSurface c = tangent_plane({1, 1, 0}, {half, half, 0});
  EXPECT_FALSE(meet(a, b, c, {}));
}

// A bowl over a plane: Newton's steps wander, and where they are after the last is no meeting.
TEST(Meet, WhereNothingMeetsNothingIsFound) {
  const LocalSurface plane = tangent_plane({}, {0, 0, 1});
  const LocalSurface wall = tangent_plane({}, {0, 1, 0});
  LocalSurface bowl = plane;
  bowl.c = {1, 0, 0, 1, 0, 1};
  for (double x = -2; x <= 2; x += 0.01) {
    EXPECT_FALSE(meet(bowl, plane, {x, 0.3, 0.5}, least_sine)) << x;
    EXPECT_FALSE(meet(bowl, plane, wall, {x, 0.3, 0.5})) << x;
  }
}

}  // namespace
}  // namespace arris
