#include "noise/noise_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/vec.h"
#include "support/job.h"
#include "support/measure.h"
#include "support/random.h"
#include "support/samplers.h"
#include "support/shapes.h"

namespace arris {
namespace {

using namespace test;

double diagonal(const Mesh& mesh) {
  Vec3 low = mesh.vertices[0], high = low;
  for (Vec3 p : mesh.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return distance(low, high);
}

std::vector<double> sorted_levels(const std::vector<Vec3>& points, unsigned threads = 1) {
  OneStageJob job(threads);
  std::vector<double> level = estimate_noise(points, NearestSample(points), job);
  std::sort(level.begin(), level.end());
  return level;
}

Mesh narrow_bars() {
  return box_complex({{{-3, -0.5, -0.5}, {3, 0.5, 0.5}},
                      {{-0.5, -3, 1.5}, {0.5, 3, 2.5}},
                      {{1.5, -0.5, -3}, {2.5, 0.5, -0.5}}});
}

std::vector<Vec3> rounded_to_float(std::vector<Vec3> points) {
  const auto round = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  for (Vec3& p : points) p = {round(p.x), round(p.y), round(p.z)};
  return points;
}

TEST(NoiseLevel, IsZeroOnBlueSamplesOfEveryShape) {
  for (const Shape& shape : all_shapes())
    EXPECT_EQ(sorted_levels(sample_blue(moved(shape.mesh, 5), 2000, 1)).back(), 0) << shape.name;
}

TEST(NoiseLevel, IsZeroOnUniformSamplesOfEveryShape) {
  for (const Shape& shape : all_shapes())
    EXPECT_EQ(sorted_levels(sample_uniform(moved(shape.mesh, 5), 2000, 1)).back(), 0) << shape.name;
}

TEST(NoiseLevel, IsZeroOnFeatureSamplesRoundedToFloat) {
  for (const Shape& shape : all_shapes()) {
    const Mesh mesh = moved(shape.mesh, 5);
    EXPECT_EQ(sorted_levels(rounded_to_float(sample_feature(mesh, 2000, 1))).back(), 0)
        << shape.name;
  }
}

// Enough points that a sample of the places may clear the cloud.
TEST(NoiseLevel, NoiseOfAPartOfALargeCloudIsFound) {
  std::vector<Vec3> points = sample_uniform(cube().mesh, 20000, 1);
  EXPECT_EQ(sorted_levels(points).back(), 0);
  Random random(3);
  std::size_t noisy = 0;
  for (Vec3& p : points) {
    if (p.x > 0.4 * diagonal(cube().mesh) / std::sqrt(3.0)) continue;
    ++noisy;
    p = p + 0.004 * Vec3{random.normal(), random.normal(), random.normal()};
  }
  const std::vector<double> level = sorted_levels(points);
  EXPECT_GT(level[points.size() - noisy / 2], 0.002);
  EXPECT_LT(level.back(), 0.008);
}

TEST(NoiseLevel, IsZeroOnAFewPoints) {
  const std::vector<Vec3> points = sample_blue(cube().mesh, 11, 1);
  EXPECT_EQ(sorted_levels(points).back(), 0);
}

TEST(NoiseLevel, IsThatOfTheNoise) {
  for (const char* name : {"sphere", "torus", "two_cubes", "l_bracket"}) {
    const Shape shape = make_shape(name);
    const double size = diagonal(shape.mesh);
    for (double share : {0.0005, 0.0025, 0.005}) {
      std::vector<Vec3> points = sample_blue(shape.mesh, 4000, 1);
      add_noise(points, share * size, 2);
      const std::vector<double> level = sorted_levels(points);
      if (level.back() == 0 && share < 0.001) continue;  // curvature may hide so little
      EXPECT_NEAR(level[level.size() / 2] / (share * size), 1, 0.2) << name << " " << share;
      EXPECT_GT(level[level.size() / 10] / (share * size), 0.7) << name << " " << share;
      EXPECT_LT(level[level.size() * 9 / 10] / (share * size), 1.4) << name << " " << share;
    }
  }
}

TEST(NoiseLevel, ShowsItselfOnPlanesFromAFewHundredthsOfTheSpacing) {
  std::vector<Vec3> points = sample_blue(cube().mesh, 4000, 1);
  const double sigma = 0.03 * ideal_spacing(6, 4000);
  add_noise(points, sigma, 2);
  const std::vector<double> level = sorted_levels(points);
  EXPECT_NEAR(level[level.size() / 2] / sigma, 1, 0.15);
}

// Bars of a few spacings leave hardly a place where a neighbourhood of 24 is flat.
TEST(NoiseLevel, IsFoundOnNarrowBars) {
  const Mesh bars = narrow_bars();
  for (const double width : {4.5, 5.0, 5.5}) {
    std::vector<Vec3> points = sample_blue(bars, samples_at_spacing(area(bars), 1 / width), 1);
    EXPECT_EQ(sorted_levels(points).back(), 0) << width;
    const double sigma = 0.03 / width;
    add_noise(points, sigma, 2);
    const std::vector<double> level = sorted_levels(points);
    EXPECT_NEAR(level[level.size() / 2] / sigma, 1, 0.35) << width;
  }
}

// Edges and narrow faces raise what single places show, to 1.6 times the noise here.
TEST(NoiseLevel, IsNotRaisedByNarrowFaces) {
  const Mesh bars = narrow_bars();
  for (const double width : {7.0, 8.0, 9.0})
    for (const double share : {0.15, 0.25}) {
      std::vector<Vec3> points = sample_blue(bars, samples_at_spacing(area(bars), 1 / width), 1);
      const double sigma = share / width;
      add_noise(points, sigma, 2);
      const std::vector<double> level = sorted_levels(points);
      EXPECT_GT(level[level.size() / 10] / sigma, 0.85) << width << " " << share;
      EXPECT_NEAR(level[level.size() / 2] / sigma, 1, 0.08) << width << " " << share;
      EXPECT_LT(level.back() / sigma, 1.25) << width << " " << share;
    }
}

// One half of a cube has twice the noise of the other; in between levels may be either.
TEST(NoiseLevel, TwoLevelsStayApart) {
  const std::vector<Vec3> clean = sample_blue(cube().mesh, 12000, 1);
  const double sigma = 0.1 * ideal_spacing(area(cube().mesh), 12000);
  double middle = 0;
  for (Vec3 p : clean) middle += p.x / static_cast<double>(clean.size());
  std::vector<Vec3> points = clean, noisier = clean;
  add_noise(points, sigma, 2);
  add_noise(noisier, 2 * sigma, 2);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (clean[i].x > middle) points[i] = noisier[i];
  OneStageJob job;
  const std::vector<double> level = estimate_noise(points, NearestSample(points), job);
  const double belt = 0.12 * diagonal(cube().mesh);
  std::vector<double> low, high;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (clean[i].x < middle - belt) low.push_back(level[i] / sigma);
    if (clean[i].x > middle + belt) high.push_back(level[i] / sigma);
  }
  std::sort(low.begin(), low.end());
  std::sort(high.begin(), high.end());
  EXPECT_GT(low.front(), 0.7);
  EXPECT_LT(low.back(), 1.3);
  EXPECT_GT(high[high.size() / 50], 1.3);
  EXPECT_NEAR(high[high.size() / 2], 2, 0.3);
}

TEST(NoiseLevel, LargerThanTheSpacing) {
  std::vector<Vec3> points = sample_uniform(sphere().mesh, 12000, 1);
  const double sigma = 1.5 * ideal_spacing(4 * 3.14159, 12000);
  add_noise(points, sigma, 2);
  const std::vector<double> level = sorted_levels(points);
  EXPECT_NEAR(level[level.size() / 2] / sigma, 1, 0.25);
}

// One half of a ball is noisy: the level is that of each place.
TEST(NoiseLevel, IsLocal) {
  std::vector<Vec3> points = sample_blue(sphere().mesh, 6000, 1), noisy = points;
  const double sigma = 0.2 * ideal_spacing(4 * 3.14159, 6000);
  add_noise(noisy, sigma, 2);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].z > 0) points[i] = noisy[i];
  OneStageJob job;
  const std::vector<double> level = estimate_noise(points, NearestSample(points), job);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].z < -0.3) {
      ASSERT_EQ(level[i], 0);
    } else if (points[i].z > 0.3) {
      ASSERT_NEAR(level[i] / sigma, 1, 0.4);
    }
  }
}

}  // namespace
}  // namespace arris
