// What is a crease and what is not, on surfaces z = f(x, y) over a jittered grid.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "arris/features.h"
#include "feature/network_laws.h"
#include "support/random.h"

namespace arris::test {
namespace {

constexpr int half = 20;  // the grid is [-half, half]^2, vertices about 1 apart

// Vertices with y = 0 stay on that line; the others are moved by up to a quarter of a step.
Mesh height_field(const std::function<double(double, double)>& height) {
  Mesh mesh;
  Random random(7);
  constexpr int n = 2 * half + 1;
  for (int j = -half; j <= half; ++j)
    for (int i = -half; i <= half; ++i) {
      const double x = i + 0.5 * (random.unit() - 0.5);
      const double y = j == 0 ? 0 : j + 0.5 * (random.unit() - 0.5);
      mesh.vertices.push_back({x, y, height(x, y)});
    }
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      const auto a = static_cast<Index>(j * n + i);
      const Index b = a + 1, c = a + n, d = c + 1;
      if (random.unit() < 0.5)
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {a, d, c}});
      else
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {b, d, c}});
    }
  return mesh;
}

FeatureNetwork features(const Mesh& mesh) {
  const auto network = find_features(mesh);
  EXPECT_TRUE(network);
  expect_sound_curves(mesh, *network);
  expect_sound_patches(mesh, *network);
  return *network;
}

// A roof whose sides meet at y = 0 under this interior angle in degrees.
double roof(double y, double angle) {
  return -std::abs(y) / std::tan(angle * std::numbers::pi / 360);
}

class Dihedral : public testing::TestWithParam<int> {};

TEST_P(Dihedral, IsFoundWithItsAngle) {
  const double angle = GetParam();
  const Mesh mesh = height_field([&](double, double y) { return roof(y, angle); });
  const FeatureNetwork network = features(mesh);
  ASSERT_EQ(network.curves.size(), 1u);
  const FeatureCurve& curve = network.curves[0];
  EXPECT_EQ(curve.vertices.size(), 2u * half + 1);
  EXPECT_EQ(curve.kind, angle < 180 ? CurveKind::convex : CurveKind::concave);
  EXPECT_NEAR(curve.mean_angle, angle, 1e-6);
  EXPECT_NEAR(curve.sharpest_angle, angle, 1e-6);
  EXPECT_EQ(network.patches, 2u);
}

INSTANTIATE_TEST_SUITE_P(From20To340, Dihedral,
                         testing::Values(20, 45, 90, 120, 150, 155, 205, 210, 240, 270, 315, 340));

TEST(Creases, OneThatFadesOutIsADanglingCurve) {
  const Mesh mesh = height_field([](double x, double y) {
    const double strength = std::clamp(-x / half, 0.0, 1.0);
    return -0.8 * std::abs(y) * strength * strength;
  });
  const FeatureNetwork network = features(mesh);
  ASSERT_EQ(network.curves.size(), 1u);
  ASSERT_EQ(network.corners.size(), 2u);
  EXPECT_EQ(network.corners[0].degree, 1u);
  EXPECT_EQ(network.corners[1].degree, 1u);
  EXPECT_EQ(network.patches, 1u);
  const double end = std::max(network.corners[0].position.x, network.corners[1].position.x);
  EXPECT_GT(end, -0.7 * half);  // where it still turns by half of what it did
  EXPECT_LE(end, 0);
  EXPECT_GT(network.curves[0].mean_angle, network.curves[0].sharpest_angle + 10);
}

TEST(Creases, ThereAreNoneOnCurvedSurfaces) {
  for (double radius : {8.0, 4.0, 2.5}) {
    SCOPED_TRACE(radius);  // the surface turns by 1 / radius at an edge: up to 23 degrees
    const Mesh waves = height_field(
        [&](double x, double y) { return radius * std::sin(x / radius) * std::cos(y / radius); });
    EXPECT_EQ(features(waves).curves.size(), 0u);
  }
}

TEST(Creases, ASpikeIsNone) {
  Mesh mesh = height_field([](double, double) { return 0; });
  mesh.vertices[mesh.vertices.size() / 2 + 5].z = 1.5;
  mesh.vertices[mesh.vertices.size() / 3].z = -0.8;
  const FeatureNetwork network = features(mesh);
  EXPECT_EQ(network.curves.size(), 0u);
  EXPECT_EQ(network.patches, 1u);
}

TEST(Creases, OneStandsOutFromNoise) {
  Random random(3);
  const Mesh mesh =
      height_field([&](double, double y) { return roof(y, 90) + 0.08 * random.normal(); });
  const FeatureNetwork network = features(mesh);
  ASSERT_GE(network.curves.size(), 1u);
  double longest = 0, all = 0;
  for (const FeatureCurve& curve : network.curves) {
    longest = std::max(longest, curve.length);
    all += curve.length;
  }
  EXPECT_GT(longest, 0.9 * 2 * half);
  EXPECT_LT(all, 1.25 * longest);
}

TEST(Creases, OneBesideACurvedPatchIsFoundAlone) {
  // A plane meets a wave, of which neighbouring rows turn by up to 14 degrees, under 41.
  const Mesh mesh = height_field(
      [](double, double y) { return y < 0 ? 0 : 4 * (std::sin(y / 4 + 0.5) - std::sin(0.5)); });
  const FeatureNetwork network = features(mesh);
  ASSERT_EQ(network.curves.size(), 1u);
  for (Index v : network.curves[0].vertices) EXPECT_EQ(mesh.vertices[v].y, 0);
  EXPECT_EQ(network.curves[0].kind, CurveKind::concave);
}

}  // namespace
}  // namespace arris::test
