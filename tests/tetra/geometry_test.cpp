#include "tetra/geometry.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "base/vec.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/tetra.h"
#include "tetra/predicates.h"

namespace arris {
namespace {

Vec3 whole_point(int range) {
  const auto c = [&] { return static_cast<double>(*rc::gen::inRange(-range, range + 1)); };
  return {c(), c(), c()};
}

RC_GTEST_PROP(Circumball, HasTheFourCornersAtItsRadius, ()) {
  const int range = *rc::gen::element(2, 10, 1000);
  const std::array<Vec3, 4> x = {whole_point(range), whole_point(range), whole_point(range),
                                 whole_point(range)};
  const Circumball ball = circumball(x[0], x[1], x[2], x[3]);
  if (orient3d(x[0], x[1], x[2], x[3]) == 0) {
    RC_ASSERT(std::isinf(ball.radius));
    return;
  }
  for (Vec3 p : x) RC_ASSERT(std::abs(distance(p, ball.centre) / ball.radius - 1) < 1e-7);
}

// A sliver whose circumcentre is known: four points of a unit circle, one of them lifted. With
// z = s the centre lies on the axis at height (r^2 + s^2 - 1) / (2 s) for a corner at radius r.
TEST(Circumball, IsRightOnSliversOfTheLastBits) {
  for (double s : {0x1p-20, 0x1p-40, 0x1p-52, 0x1p-60}) {
    const double r = 1 + 0x1p-52;
    const double height = (0x1p-51 + 0x1p-104 + s * s) / (2 * s);
    const Circumball ball = circumball({1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -r, s});
    EXPECT_NEAR(ball.centre.z, height, 1e-7 * std::hypot(1, height)) << s;
    EXPECT_NEAR(ball.radius / std::hypot(1, height), 1, 1e-7) << s;
  }
}

TEST(Circumball, OfEveryTetrahedronOfATiltedFaceIsEmpty) {
  // Faces of a tilted cube sampled exactly: thousands of slivers.
  test::Random random(1);
  const Mesh box = test::moved(test::cube().mesh, 7);
  std::vector<Vec3> points = box.vertices;
  for (const Triangle& t : box.triangles)
    for (int k = 0; k < 60; ++k) {
      const double a = random.unit(), b = (1 - a) * random.unit();
      const Vec3 o = box.vertices[t[0]];
      points.push_back(o + a * (box.vertices[t[1]] - o) + b * (box.vertices[t[2]] - o));
    }
  const test::Measured m(points);
  std::size_t slivers = 0;
  for (Tet t = 0; t < m.mesh.finite; ++t) {
    const Circumball& ball = m.balls[t];
    if (!std::isfinite(ball.radius)) continue;
    slivers += ball.radius > 10;
    double nearest = ball.radius;
    for (Vec3 p : m.mesh.points) nearest = std::min(nearest, distance(p, ball.centre));
    EXPECT_GT(nearest / ball.radius, 1 - 1e-7);
  }
  EXPECT_GT(slivers, 100u);
}

TEST(Circumball, OfCoplanarOrEqualPointsIsInfinite) {
  EXPECT_TRUE(std::isinf(circumball({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}).radius));
  EXPECT_TRUE(std::isinf(circumball({0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}).radius));
}

std::vector<Vec3> grid(int side, double step) {
  std::vector<Vec3> points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) points.push_back({step * x, step * y, step * z});
  return points;
}

TEST(SampleSpacing, OfARegularGridIsItsStep) {
  for (double step : {1.0, 0.25, 1e-3})
    for (double h : test::Measured(grid(6, step)).spacing) EXPECT_NEAR(h, step, 1e-12 * step);
}

TEST(SampleSpacing, FollowsADensityThatChanges) {
  std::vector<Vec3> points = grid(6, 1);
  for (Vec3 p : grid(6, 0.1)) points.push_back(p + Vec3{20, 0, 0});
  const test::Measured m(points);
  for (std::size_t v = 0; v < points.size(); ++v)
    EXPECT_NEAR(m.spacing[v], v < 216 ? 1 : 0.1, 1e-12);
}

TEST(SampleSpacing, IsPositiveWhereSquaredDistancesUnderflow) {
  std::vector<Vec3> points = grid(3, 1e-200);
  points.push_back({1, 1, 1});
  points.push_back({1, 0, 1});
  for (double h : test::Measured(points).spacing) EXPECT_GT(h * h * h, 0);
}

}  // namespace
}  // namespace arris
