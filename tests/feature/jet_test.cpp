// The polynomial of third order that points on smooth surfaces are taken from.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>
#include <random>

#include "base/vec.h"
#include "feature/jet.h"

namespace arris {
namespace {

struct Cloud {
  std::vector<Vec3> points;
  std::vector<Index> members;
};

// Points of z = f(x, y) with x and y within 2.
template <class F>
Cloud cloud_of(F f, std::size_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> side(-2, 2);
  Cloud cloud;
  for (std::size_t k = 0; k < n; ++k) {
    const double x = side(random), y = side(random);
    cloud.points.push_back({x, y, f(x, y)});
  }
  cloud.members.resize(n);
  std::iota(cloud.members.begin(), cloud.members.end(), Index{0});
  return cloud;
}

RC_GTEST_PROP(Jet, ReproducesCubics, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> number(-0.1, 0.1);
  std::array<double, 10> c;
  for (double& x : c) x = number(random);
  const auto f = [&](double x, double y) {
    return c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y +
           c[6] * x * x * x + c[7] * x * x * y + c[8] * x * y * y + c[9] * y * y * y;
  };
  const Cloud cloud = cloud_of(f, 40, seed);
  const Jet jet = fit_jet(cloud.points, cloud.members, {0, 0, 0}, {0, 0, 1}, 1);
  RC_ASSERT(std::abs(jet.height({0, 0, 0}) - c[0]) < 5e-3);
  RC_ASSERT(std::abs(jet.height({0.5, -0.3, 7}) - f(0.5, -0.3)) < 5e-3);
  RC_ASSERT(jet.residual < 1e-2);
  const Vec3 n{-c[1], -c[2], 1};
  RC_ASSERT(dot(jet.normal(), n) > 0.999 * length(n));
}

TEST(Jet, DoesNotDependOnTheUnit) {
  const Cloud cloud =
      cloud_of([](double x, double y) { return 0.1 * x * y - 0.05 * x * x; }, 24, 5);
  Cloud large = cloud;
  for (Vec3& p : large.points) p = 1000 * p;
  const Jet a = fit_jet(cloud.points, cloud.members, {0, 0, 0}, {0, 0, 1}, 0.5);
  const Jet b = fit_jet(large.points, large.members, {0, 0, 0}, {0, 0, 1}, 500);
  EXPECT_NEAR(1000 * a.height({1, 1, 0}), b.height({1000, 1000, 0}), 1e-6);
  EXPECT_NEAR(1000 * a.residual, b.residual, 1e-6);
}

TEST(Jet, TheResidualIsThatOfTheNoise) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.01);
  double sum = 0;
  constexpr int rounds = 50;
  for (int k = 0; k < rounds; ++k) {
    const Cloud cloud =
        cloud_of([&](double, double) { return noise(random); }, 24, static_cast<std::uint64_t>(k));
    sum += fit_jet(cloud.points, cloud.members, {0, 0, 0}, {0, 0, 1}, 1).residual;
  }
  EXPECT_NEAR(sum / rounds, 0.01, 0.003);
}

}  // namespace
}  // namespace arris
