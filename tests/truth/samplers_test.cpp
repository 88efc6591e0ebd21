#include "truth/samplers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

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
  EXPECT_EQ(feature_points(cone().mesh, 10).size(), 2u) << "one on the rim, one at the tip";
}

// Mesh files need not be closed: where the surface ends is an edge.
TEST(Samplers, FeatureTakesBoundariesForEdges) {
  Mesh open = cube().mesh;
  open.triangles.resize(open.triangles.size() - 1);
  const Samples features = feature_samples(open, 10);
  EXPECT_EQ(features.size(), 8u);
  const Samples all = sample(open, {Mode::feature, 500, 1});
  EXPECT_EQ(all.size(), 500u);
}

TEST(Samplers, DirectionsAreOutwardUnitNormals) {
  const Mesh ball = sphere().mesh, box = cube().mesh;
  for (const Mode mode : {Mode::uniform, Mode::blue, Mode::graded, Mode::feature}) {
    const Samples round = sample(ball, {mode, 300, 1}), flat = sample(box, {mode, 300, 1});
    ASSERT_EQ(round.directions.size(), round.size());
    for (std::size_t i = 0; i < round.size(); ++i)
      EXPECT_GT(dot(round.directions[i], round.positions[i]), 0.99);
    for (std::size_t i = 0; i < flat.size(); ++i) {
      EXPECT_NEAR(length(flat.directions[i]), 1, 1e-12);
      // On edges and corners too, the way out leads away from the centre.
      EXPECT_GT(dot(flat.directions[i], flat.positions[i] - Vec3{0.5, 0.5, 0.5}), 0.49);
    }
  }
}

// Pearson's chi-squared over 6 x 8 x 8 equal squares: mean 383, deviation 28 if uniform.
TEST(Samplers, UniformPassesChiSquared) {
  constexpr int cells = 8;
  constexpr std::size_t n = 38400;
  std::vector<double> counts(6 * cells * cells, 0);
  for (const Vec3 p : sample_uniform(cube().mesh, n, 5)) {
    const std::array<double, 3> c = {p.x, p.y, p.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (c[axis] != 0 && c[axis] != 1) continue;
      const auto cell = [&](std::size_t k) {
        return std::min(static_cast<std::size_t>(c[(axis + k) % 3] * cells),
                        std::size_t{cells - 1});
      };
      ++counts[((2 * axis + (c[axis] == 1)) * cells + cell(1)) * cells + cell(2)];
    }
  }
  constexpr double expected = static_cast<double>(n) / (6 * cells * cells);
  double chi_squared = 0;
  for (const double count : counts)
    chi_squared += (count - expected) * (count - expected) / expected;
  EXPECT_GT(chi_squared, 383 - 4 * 28);
  EXPECT_LT(chi_squared, 383 + 4 * 28);
}

// Density 10^-t along the unknown direction: the two ends of a long bar differ about tenfold if it
// lies along that, and samples keep the distance that their density allows.
TEST(Samplers, GradedIsTenTimesDenserAtOneEnd) {
  const Mesh bar = box_complex({{{0, 0, 0}, {100, 1, 1}}});
  const std::vector<Vec3> points = sample(bar, {Mode::graded, 4000, 3}).positions;
  ASSERT_EQ(points.size(), 4000u);
  double first = 0, last = 0;
  for (const Vec3 p : points) {
    first += p.x < 10;
    last += p.x > 90;
  }
  // Over the first and last tenth: 10^0.9, whichever end is dense.
  EXPECT_NEAR(std::max(first, last) / std::min(first, last), std::pow(10, 0.9), 1.2);
  EXPECT_GT(nearest_pair(points), 0.5 * ideal_spacing(400 * 0.39, 4000));
}

TEST(Samplers, RefuseWhatHasNoSurface) {
  Mesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 2}};
  for (const Mode mode : {Mode::uniform, Mode::blue, Mode::graded, Mode::feature})
    EXPECT_THROW(sample(flat, {mode, 10, 1}), std::invalid_argument);
  Mesh needle;
  needle.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-30, 0}};
  needle.triangles = {{0, 1, 2}};
  EXPECT_THROW(sample(needle, {Mode::feature, 10, 1}), std::invalid_argument);
  Mesh broken = cube().mesh;
  broken.triangles[0][0] = 99;
  EXPECT_THROW(sample(broken, {}), std::invalid_argument);
  Mesh infinite = cube().mesh;
  infinite.vertices[0].x = std::numeric_limits<double>::infinity();
  EXPECT_THROW(sample(infinite, {}), std::invalid_argument);
}

}  // namespace
}  // namespace arris::truth
