#include "truth/samplers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/vec.h"
#include "truth/measure.h"
#include "truth/random.h"
#include "truth/shapes.h"

namespace arris::truth {
namespace {

double nearest_pair(const std::vector<Vec3>& points) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, distance(points[i], points[j]));
  return nearest;
}

// Distance to the nearest edge of a unit cube, for a point on it.
double distance_to_cube_edge(Vec3 p) {
  std::array<double, 3> d{};
  std::size_t i = 0;
  for (const double c : {p.x, p.y, p.z}) d[i++] = std::min(std::abs(c), std::abs(1 - c));
  std::sort(d.begin(), d.end());
  return std::hypot(d[0], d[1]);
}

TEST(Random, IsSplitmix64) {
  Random random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317u);
  EXPECT_EQ(random.next(), 3203168211198807973u);
}

TEST(Random, NormalHasItsMoments) {
  Random random(1);
  constexpr int n = 100000;
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / n, 0, 0.02);
  EXPECT_NEAR(squares / n, 1, 0.02);
}

TEST(Samplers, LieOnTheSurfaceAndAreAsManyAsAsked) {
  for (const Shape& shape : all_shapes()) {
    const Mesh mesh = moved(shape.mesh, 3);
    for (const auto& points : {sample_uniform(mesh, 300, 1), sample_blue(mesh, 300, 1)}) {
      EXPECT_EQ(points.size(), 300u) << shape.name;
      for (const Vec3 p : points) ASSERT_LT(distance_to_mesh(p, mesh), 1e-12) << shape.name;
    }
    const std::vector<Vec3> feature = sample_feature(mesh, 300, 1);
    EXPECT_GE(feature.size(), 300u) << shape.name;
    for (const Vec3 p : feature) ASSERT_LT(distance_to_mesh(p, mesh), 1e-12) << shape.name;
  }
}

TEST(Samplers, DependOnTheirSeedAlone) {
  const Mesh mesh = two_cubes().mesh;
  EXPECT_EQ(sample_uniform(mesh, 200, 7), sample_uniform(mesh, 200, 7));
  EXPECT_NE(sample_uniform(mesh, 200, 7), sample_uniform(mesh, 200, 8));
  EXPECT_EQ(sample_blue(mesh, 200, 7), sample_blue(mesh, 200, 7));
  EXPECT_NE(sample_blue(mesh, 200, 7), sample_blue(mesh, 200, 8));
  EXPECT_EQ(sample_feature(mesh, 200, 7), sample_feature(mesh, 200, 7));
}

TEST(Samplers, UniformFollowsTheArea) {
  const std::vector<Vec3> points = sample_uniform(thin_plate().mesh, 20000, 2);
  const auto top = std::count_if(points.begin(), points.end(), [](Vec3 p) { return p.z == 0.05; });
  EXPECT_NEAR(static_cast<double>(top) / 20000, 1 / 2.2, 0.02);
}

TEST(Samplers, BlueIsEvenAndOffTheEdges) {
  const Mesh mesh = cube().mesh;
  const std::vector<Vec3> points = sample_blue(mesh, 1000, 4);
  const double spacing = ideal_spacing(6, 1000);
  EXPECT_GT(nearest_pair(points), 0.55 * spacing);
  EXPECT_LT(nearest_pair(sample_uniform(mesh, 1000, 4)), 0.2 * spacing);
  for (const Vec3 p : points) EXPECT_GT(distance_to_cube_edge(p), 0);
}

TEST(Samplers, FeatureCoversCornersAndEdges) {
  const std::vector<Vec3> points = sample_feature(cube().mesh, 1000, 4);
  EXPECT_EQ(points.size(), 1000u);
  const auto has = [&](Vec3 p) {
    return std::find(points.begin(), points.end(), p) != points.end();
  };
  for (const Vec3 corner : cube().mesh.vertices) EXPECT_TRUE(has(corner));
  const double spacing = ideal_spacing(6, 1000);
  const auto on_edges = std::count_if(points.begin(), points.end(),
                                      [](Vec3 p) { return distance_to_cube_edge(p) == 0; });
  EXPECT_EQ(on_edges, 8 + 12 * (static_cast<long>(std::ceil(1 / spacing)) - 1));
  EXPECT_GT(nearest_pair(points), 0.5 * spacing);
}

TEST(Samplers, FeatureFindsRimsWithoutCorners) {
  const std::vector<Vec3> rims = feature_points(cylinder().mesh, 0.1);
  EXPECT_EQ(rims.size(), 2 * 32u);  // a rim is pi - a little, long
  for (const Vec3 p : rims) {
    EXPECT_TRUE(p.z == 0 || p.z == 1);
    EXPECT_NEAR(std::hypot(p.x, p.y), 0.5, 0.001);
  }
  EXPECT_TRUE(feature_points(sphere().mesh, 0.1).empty());
  EXPECT_EQ(feature_points(cone().mesh, 10).size(), 1u) << "one on the rim, none at the tip";
}

TEST(Samplers, NoiseAndOutliersAreAsAsked) {
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

}  // namespace
}  // namespace arris::truth
