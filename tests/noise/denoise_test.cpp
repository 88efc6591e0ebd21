#include "noise/denoise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/vec.h"
#include "support/job.h"
#include "support/known_solids.h"
#include "support/measure.h"
#include "support/samplers.h"
#include "support/shapes.h"

namespace arris {
namespace {

using namespace test;

double mean_distance(const std::vector<Vec3>& points, const std::function<double(Vec3)>& distance) {
  double sum = 0;
  for (Vec3 p : points) sum += std::abs(distance(p));
  return sum / static_cast<double>(points.size());
}

Denoised run(const std::vector<Vec3>& points, double level = -1, unsigned threads = 1) {
  OneStageJob job(threads);
  return denoise(points, level, job);
}

double cube_distance(Vec3 p) {
  return box_distance(p, 0, 1);
}

double sphere_distance(Vec3 p) {
  return length(p) - 1;
}

TEST(Denoise, MovesNothingOfACleanCloud) {
  for (const char* name : {"cube", "sphere", "torus", "cone", "thin_plate", "steps"}) {
    const std::vector<Vec3> points = sample_blue(moved(make_shape(name).mesh, 3), 2000, 1);
    const Denoised clean = run(points);
    EXPECT_EQ(clean.moved, 0u) << name;
    EXPECT_EQ(clean.points, points) << name;  // bit for bit
    EXPECT_EQ(clean.highest_level, 0) << name;
  }
}

TEST(Denoise, LevelZeroMovesNothing) {
  std::vector<Vec3> points = sample_blue(cube().mesh, 1000, 1);
  add_noise(points, 0.01, 2);
  EXPECT_EQ(run(points, 0).points, points);
}

TEST(Denoise, BringsSamplesToTheSurface) {
  const double size = std::sqrt(3.0);
  for (double share : {0.0005, 0.005}) {
    std::vector<Vec3> flat = sample_blue(cube().mesh, 4000, 1);
    add_noise(flat, share * size, 2);
    EXPECT_LT(mean_distance(run(flat).points, cube_distance),
              0.25 * mean_distance(flat, cube_distance))
        << share;
    std::vector<Vec3> round = sample_blue(sphere().mesh, 4000, 1);
    add_noise(round, share * 2 * size, 2);
    EXPECT_LT(mean_distance(run(round).points, sphere_distance),
              0.45 * mean_distance(round, sphere_distance))
        << share;
  }
}

TEST(Denoise, GivenLevelNeedsNoEstimate) {
  std::vector<Vec3> points = sample_blue(cube().mesh, 4000, 1);
  add_noise(points, 0.004, 2);
  const Denoised clean = run(points, 0.004);
  EXPECT_EQ(clean.median_level, 0.004);
  EXPECT_LT(mean_distance(clean.points, cube_distance),
            0.25 * mean_distance(points, cube_distance));
}

// Samples may go to an edge or their own side of it, not away from both.
TEST(Denoise, KeepsEdges) {
  const std::vector<Vec3> truth = sample_blue(cube().mesh, 4000, 1);
  std::vector<Vec3> points = truth;
  const double sigma = 0.0025 * std::sqrt(3.0), spacing = ideal_spacing(6, 4000);
  add_noise(points, sigma, 2);
  const Denoised clean = run(points);
  std::size_t near = 0, good = 0, across = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Vec3 p = truth[i];
    std::array<double, 3> gap{};
    const std::array<double, 3> at{p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k) gap[k] = std::min(at[k], 1 - at[k]);
    std::sort(gap.begin(), gap.end());
    if (gap[1] > 1.5 * spacing) continue;  // the distance to the nearest edge
    ++near;
    good += std::abs(cube_distance(clean.points[i])) < sigma ? 1 : 0;
    // Beyond the edge: its own coordinate is more than the noise away from the face it is of.
    across += distance(clean.points[i], p) > 4 * std::sqrt(3.0) * sigma ? 1 : 0;
  }
  ASSERT_GT(near, 500u);
  EXPECT_GT(good, near * 95 / 100);
  EXPECT_LE(across, near / 500);  // the noise itself may have put it there
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LT(distance(clean.points[i], points[i]), 6 * clean.level[i]);
}

// Three scans on top of each other, each with noise as large as the spacing of all.
TEST(Denoise, NoiseLargerThanTheSpacing) {
  std::vector<Vec3> points;
  for (std::uint64_t scan = 0; scan < 3; ++scan)
    for (Vec3 p : sample_uniform(sphere().mesh, 3000, 10 + scan)) points.push_back(p);
  const double sigma = ideal_spacing(4 * 3.14159, points.size());
  add_noise(points, sigma, 2);
  EXPECT_LT(mean_distance(run(points).points, sphere_distance), 0.35 * sigma);
}

TEST(Denoise, ThreadsDoNotChangeABit) {
  std::vector<Vec3> points = sample_blue(two_cubes().mesh, 3000, 1);
  add_noise(points, 0.005, 2);
  const Denoised one = run(points, -1, 1), two = run(points, -1, 2);
  EXPECT_GT(one.moved, 2000u);
  EXPECT_EQ(one.points, two.points);
  EXPECT_EQ(one.level, two.level);
}

}  // namespace
}  // namespace arris
