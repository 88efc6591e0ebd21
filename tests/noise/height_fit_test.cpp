#include "noise/height_fit.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "base/vec.h"
#include "support/random.h"

namespace arris {
namespace {

using test::Random;

Vec3 random_direction(Random& random) {
  const Vec3 d{random.normal(), random.normal(), random.normal()};
  return 1 / length(d) * d;
}

RC_GTEST_PROP(HeightFit, FindsAnExactQuadric, (unsigned seed)) {
  Random random(seed);
  std::array<double, 6> c{};
  for (double& x : c) x = random.unit() - 0.5;
  std::vector<Vec3> points;
  for (int i = 0; i < 30; ++i) {
    const double x = 2 * random.unit() - 1, y = 2 * random.unit() - 1;
    points.push_back(
        {x, y, c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y});
  }
  const HeightFit fit = fit_heights(frame_at({}, {0, 0, 1}), points, 1, quadric_terms);
  RC_ASSERT(fit.terms == quadric_terms);
  for (std::size_t i = 0; i < c.size(); ++i) RC_ASSERT(std::abs(fit.c[i] - c[i]) < 1e-9);
  RC_ASSERT(residual_deviation(fit, points) < 1e-9);
}

RC_GTEST_PROP(HeightFit, LeastVarianceIsTheNormalOfAPlane, (unsigned seed)) {
  Random random(seed);
  const Vec3 normal = random_direction(random);
  const Frame frame = frame_at({1, 2, 3}, normal);
  RC_ASSERT(std::abs(dot(frame.x, frame.y)) < 1e-12);
  RC_ASSERT(length(cross(frame.x, frame.y) - normal) < 1e-12);
  std::vector<Vec3> points;
  for (int i = 0; i < 20; ++i)
    points.push_back(frame.origin + random.normal() * frame.x + random.normal() * frame.y);
  RC_ASSERT(std::abs(dot(least_variance_direction(points), normal)) > 1 - 1e-9);
  const HeightFit fit = fit_heights(frame, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, 1, 3);
  const HeightFit::Offset offset = fit.offset(frame.origin + 0.5 * normal + 3 * frame.x);
  RC_ASSERT(std::abs(offset.distance - 0.5) < 1e-9);
}

// The predicted variance of a fit is what repeated noise gives.
TEST(HeightFit, VarianceIsThatOfRepeatedNoise) {
  Random random(1);
  std::vector<Vec3> points;
  for (int i = 0; i < 25; ++i) points.push_back({random.normal(), random.normal(), 0});
  constexpr int times = 4000;
  double sum = 0, predicted = 0;
  for (int i = 0; i < times; ++i) {
    for (Vec3& p : points) p.z = random.normal();
    const HeightFit fit = fit_heights(frame_at({}, {0, 0, 1}), points, 2, quadric_terms);
    const double h = fit.height(0.7, -0.4);
    sum += h * h;
    predicted = fit.variance(0.7, -0.4);
  }
  EXPECT_NEAR(sum / times / predicted, 1, 0.1);
}

TEST(HeightFit, RefusesWhatDoesNotDetermineIt) {
  const Frame frame = frame_at({}, {0, 0, 1});
  EXPECT_EQ(fit_heights(frame, {{0, 0, 0}, {1, 0, 0}}, 1, plane_terms).terms, 0);
  std::vector<Vec3> line;
  for (int i = 0; i < 9; ++i) line.push_back({0.1 * i, 0, 0});
  EXPECT_EQ(fit_heights(frame, line, 1, plane_terms).terms, 0);
}

}  // namespace
}  // namespace arris
