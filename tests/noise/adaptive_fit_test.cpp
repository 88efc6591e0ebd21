#include "noise/adaptive_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/vec.h"

namespace arris {
namespace {

constexpr double level = 0.3;  // of a spacing of 1
constexpr std::size_t patches = 100;

const Frame upright{{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

// Four hundred samples of z = bend x² / 2, nearest first.
std::vector<Vec3> parabola(double bend, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-10, 10);
  std::normal_distribution<double> noise(0, level);
  std::vector<Vec3> points;
  for (int k = 0; k < 400; ++k) {
    const double x = place(random), y = place(random);
    points.push_back({x, y, bend * x * x / 2 + noise(random)});
  }
  std::sort(points.begin(), points.end(),
            [](Vec3 a, Vec3 b) { return a.x * a.x + a.y * a.y < b.x * b.x + b.y * b.y; });
  return points;
}

// The mean height of the patch over the middle of the parabola, which is 0 there, and how many
// patches are planes.
struct Middles {
  double height = 0;
  std::size_t planes = 0, members = 0;
};

Middles fit_middles(double bend) {
  Middles all;
  for (unsigned seed = 0; seed < patches; ++seed) {
    const PatchFit patch = fit_patch(parabola(bend, seed), upright, level);
    all.height += patch.fit.height(0, 0) / patches;
    all.planes += patch.fit.terms == plane_terms;
    all.members += patch.count / patches;
  }
  return all;
}

TEST(FitPatch, TakesAllOfAPlane) {
  const Middles plane = fit_middles(0);
  EXPECT_GE(plane.planes, 8 * patches / 10);
  EXPECT_GE(plane.members, 250u);
  EXPECT_NEAR(plane.height, 0, 0.02 * level);
}

// The whole sags by little more than a deviation of the noise. Residuals alone hide it from two
// planes of three, and leave the middles a sixth of a deviation too high.
TEST(FitPatch, PlanesDoNotBend) {
  const Middles bent = fit_middles(0.007);
  EXPECT_LE(bent.planes, patches / 3);
  EXPECT_NEAR(bent.height, 0, 0.1 * level);
}

TEST(FitPatch, NeedsEnoughSamplesToTellTheNormal) {
  std::vector<Vec3> few = parabola(0, 1);
  few.resize(9);
  EXPECT_EQ(fit_patch(few, upright, level).fit.terms, 0);
}

}  // namespace
}  // namespace arris
