// Noise, outliers and missing patches: as large, as many and where they were asked for.
#include "truth/cloud.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "base/vec.h"
#include "truth/measure.h"
#include "truth/shapes.h"

namespace arris::truth {
namespace {

std::vector<Vec3> sorted(std::vector<Vec3> points) {
  std::sort(points.begin(), points.end(), lexicographic_less);
  return points;
}

bool contains(const std::vector<Vec3>& all, const std::vector<Vec3>& some) {
  const std::vector<Vec3> a = sorted(all), b = sorted(some);
  return std::includes(a.begin(), a.end(), b.begin(), b.end(), lexicographic_less);
}

CloudOptions options_of(std::size_t n, Mode mode = Mode::blue) {
  CloudOptions options;
  options.sampling.samples = n;
  options.sampling.mode = mode;
  return options;
}

TEST(Cloud, NoiseAndOutliersAreAsAsked) {
  const std::vector<Vec3> clean = sample_blue(cube().mesh, 2000, 1);
  std::vector<Vec3> noisy = clean;
  add_noise(noisy, 0.01, 2);
  double squares = 0;
  for (std::size_t i = 0; i < clean.size(); ++i) squares += squared_length(noisy[i] - clean[i]);
  EXPECT_NEAR(std::sqrt(squares / 6000), 0.01, 0.0005);

  std::vector<Vec3> dirty = clean;
  add_outliers(dirty, 100, 3);
  ASSERT_EQ(dirty.size(), 2100u);
  EXPECT_TRUE(std::equal(clean.begin(), clean.end(), dirty.begin()));
  std::size_t off = 0;
  for (std::size_t i = 2000; i < 2100; ++i) off += distance_to_mesh(dirty[i], cube().mesh) > 0.001;
  EXPECT_GT(off, 90u);
}

TEST(Cloud, NoiseAlongNormalsLeavesThePlane) {
  const Samples clean = sample(sphere().mesh, {Mode::uniform, 4000, 1});
  Samples noisy = clean;
  add_noise(noisy, 0.02, NoiseDirection::along, 7);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < clean.size(); ++i) {
    const Vec3 move = noisy.positions[i] - clean.positions[i];
    const double along = dot(move, clean.directions[i]);
    EXPECT_LT(length(move - along * clean.directions[i]), 1e-12);
    sum += along;
    squares += along * along;
  }
  EXPECT_NEAR(sum / 4000, 0, 0.001);
  EXPECT_NEAR(std::sqrt(squares / 4000), 0.02, 0.001);
}

// The distance from a cube that was sampled is the noise, in either unit.
TEST(Cloud, NoiseIsInDiagonalsOrSpacings) {
  CloudOptions options = options_of(3000, Mode::uniform);
  const auto deviation = [&] {
    double squares = 0;
    for (const Vec3 p : make_cloud(cube().mesh, options).points.positions) {
      const double d = distance_to_mesh(p, cube().mesh);
      squares += d * d;
    }
    return std::sqrt(squares / 3000);
  };
  options.noise = 0.002;
  EXPECT_NEAR(deviation(), 0.002 * std::sqrt(3.0), 2e-4);
  options.noise = 0.25;
  options.noise_in_spacings = true;
  EXPECT_NEAR(deviation(), 0.25 * ideal_spacing(6, 3000), 6e-4);
}

TEST(Cloud, OptionsLeaveTheOtherPointsAsTheyAre) {
  const Mesh mesh = two_cubes().mesh;
  CloudOptions options = options_of(1000);
  const std::vector<Vec3> clean = make_cloud(mesh, options).points.positions;
  EXPECT_EQ(clean.size(), 1000u);

  options.outliers = 0.05;
  const Cloud dirty = make_cloud(mesh, options);
  EXPECT_EQ(dirty.outliers, 50u);
  EXPECT_EQ(dirty.points.positions.size(), 1050u);
  EXPECT_TRUE(contains(dirty.points.positions, clean));

  options.outliers = 0;
  options.missing = 2;
  const Cloud torn = make_cloud(mesh, options);
  EXPECT_GT(torn.missing, 10u);
  EXPECT_EQ(torn.points.positions.size(), 1000 - torn.missing);
  EXPECT_TRUE(contains(clean, torn.points.positions));
}

TEST(Cloud, AMissingPatchIsABall) {
  Samples samples = sample(cube().mesh, {Mode::blue, 2000, 1});
  const Samples before = samples;
  remove_patches(samples, 1, 0.2, 5);
  const std::vector<Vec3> left = sorted(samples.positions);
  std::vector<Vec3> gone;
  for (const Vec3 p : before.positions)
    if (!std::binary_search(left.begin(), left.end(), p, lexicographic_less)) gone.push_back(p);
  // On a face a disk of radius 0.2, unless it reaches over an edge.
  EXPECT_NEAR(static_cast<double>(gone.size()), 2000 * 3.14 * 0.04 / 6, 15);
  Vec3 centre = gone.front();  // one of the samples that are gone, nearer than 0.2 to all of them
  double radius = 1;
  for (const Vec3 c : gone) {
    double farthest = 0;
    for (const Vec3 p : gone) farthest = std::max(farthest, distance(c, p));
    if (farthest < radius) radius = farthest, centre = c;
  }
  EXPECT_LT(radius, 0.2);
  for (const Vec3 p : left) EXPECT_GE(distance(p, centre), radius);
}

TEST(Cloud, DependsOnItsSeedAlone) {
  CloudOptions options = options_of(500);
  options.noise = 0.01;
  options.outliers = 0.1;
  options.missing = 1;
  const Mesh mesh = torus().mesh;
  for (const Mode mode : {Mode::uniform, Mode::blue, Mode::feature, Mode::graded, Mode::scan}) {
    options.sampling.mode = mode;
    options.sampling.seed = 4;
    const std::vector<Vec3> first = make_cloud(mesh, options).points.positions;
    EXPECT_EQ(make_cloud(mesh, options).points.positions, first);
    options.sampling.seed = 5;
    EXPECT_NE(make_cloud(mesh, options).points.positions, first);
  }
}

TEST(Cloud, HoldsFloats) {
  const Cloud cloud = make_cloud(torus().mesh, options_of(200));
  EXPECT_EQ(cloud.points.position_type, ScalarType::f32);
  for (const Vec3 p : cloud.points.positions) {
    EXPECT_EQ(p.x, static_cast<double>(static_cast<float>(p.x)));
    EXPECT_LT(distance_to_mesh(p, torus().mesh), 1e-6);
  }
}

TEST(Cloud, RefusesToBeEmpty) {
  CloudOptions options = options_of(100);
  options.missing = 1;
  options.missing_radius = 1;
  EXPECT_THROW(make_cloud(cube().mesh, options), std::invalid_argument);
}

}  // namespace
}  // namespace arris::truth
