#include "cut/level_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "base/vec.h"
#include "support/known_solids.h"
#include "support/measure.h"
#include "surface/extract.h"
#include "tetra/background.h"

namespace arris {
namespace {

using namespace test;

// A ball of radius R in a mesh with background points, labelled by formula.
struct Ball {
  double radius;
  TetMesh mesh;
  Labels labels;
  double spacing = 0;

  explicit Ball(double r, std::size_t n = 600) : radius(r) {
    std::vector<Vec3> points = sample_blue(sphere().mesh, n, 1);
    for (Vec3& p : points) p = r / length(p) * p;
    const Measured coarse(points);
    OneStageJob job;
    const Background background = background_points(points, coarse.spacing, LocalFrame{}, 10, job);
    points.insert(points.end(), background.points.begin(), background.points.end());
    mesh = delaunay(points, n, job);
    mesh.nearest = nearest_samples(n, background);
    labels.assign(mesh.size(), 0);
    for (Tet t = 0; t < mesh.finite; ++t) labels[t] = length(centroid_of(mesh, t)) < r;
    spacing = coarse.spacing[0];
  }

  std::vector<double> distances() const {
    OneStageJob job;
    return signed_distance(mesh, Stars(mesh), labels, job);
  }
};

TEST(SignedDistance, AgreesWithBruteForce) {
  const Ball ball(1, 300);
  const ExtractedSurface surface = extract_surface(ball.mesh, ball.labels);
  Mesh boundary;
  boundary.triangles = surface.triangles;
  for (Index v : surface.point) boundary.vertices.push_back(ball.mesh.points[v]);
  const std::vector<double> distance = ball.distances();
  std::size_t off = 0;
  double worst = 0;
  for (std::size_t v = 0; v < distance.size(); ++v) {
    const double exact = distance_to_mesh(ball.mesh.points[v], boundary);
    EXPECT_GE(std::abs(distance[v]), exact - 1e-12);
    off += std::abs(distance[v]) > exact + 1e-12;
    worst = std::max(worst, std::abs(distance[v]) - exact);
  }
  EXPECT_LT(off, distance.size() * 3 / 10);  // measured: 22 %
  EXPECT_LT(worst, 0.15 * ball.spacing);     // measured: 0.11
  for (Index v : surface.point) EXPECT_EQ(distance[v], 0);
}

TEST(SignedDistance, IsNegativeInside) {
  const Ball ball(1, 300);
  const std::vector<double> distance = ball.distances();
  for (std::size_t v = 0; v < distance.size(); ++v) {
    const double d = length(ball.mesh.points[v]) - 1;
    if (std::abs(d) > 0.1) {
      EXPECT_EQ(distance[v] < 0, d < 0) << d;
    }
  }
}

TEST(SignedDistance, WithoutASurfaceIsInfinite) {
  Ball ball(1, 100);
  std::fill(ball.labels.begin(), ball.labels.end(), std::uint8_t{0});
  for (double d : ball.distances()) EXPECT_TRUE(std::isinf(d));
}

struct Spread {
  double median = 0, deviation = 0;  // deviation: median of the absolute one
};

// Of the curvature at the samples, in units of the true 2 / R.
Spread curvature_at_samples(const Ball& ball, const std::vector<double>& distance) {
  const std::vector<double> kappa = level_set_curvature(ball.mesh, distance);
  std::vector<double> ratio;
  for (std::size_t v = 0; v < ball.mesh.samples; ++v) ratio.push_back(kappa[v] * ball.radius / 2);
  const auto median = [](std::vector<double> x) {
    std::nth_element(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2), x.end());
    return x[x.size() / 2];
  };
  Spread spread{median(ratio), 0};
  for (double& r : ratio) r = std::abs(r - spread.median);
  spread.deviation = median(ratio);
  return spread;
}

// The discretization alone: given the exact distance.
TEST(LevelSetCurvature, OfTheDistanceToASphereIsTwoOverItsRadius) {
  for (double r : {0.5, 1.0, 3.0}) {
    const Ball ball(r);
    std::vector<double> distance;
    for (Vec3 p : ball.mesh.points) distance.push_back(length(p) - r);
    const Spread s = curvature_at_samples(ball, distance);
    EXPECT_NEAR(s.median, 1, 0.1) << r;  // measured: 1.066 at a spacing of 0.14 R
    EXPECT_LT(s.deviation, 0.2) << r;
  }
}

TEST(LevelSetCurvature, OfATriangulatedSphereIsTwoOverItsRadius) {
  for (double r : {0.5, 1.0, 3.0}) {
    const Ball ball(r);
    const Spread s = curvature_at_samples(ball, ball.distances());
    EXPECT_NEAR(s.median, 1, 0.2) << r;
    EXPECT_LT(s.deviation, 0.4) << r;
  }
}

TEST(LevelSetCurvature, OfAPlaneIsZero) {
  const Ball ball(1);
  std::vector<double> height;
  for (Vec3 p : ball.mesh.points) height.push_back(p.z + 0.5 * p.x);
  const std::vector<double> kappa = level_set_curvature(ball.mesh, height);
  for (std::size_t v = 0; v < ball.mesh.samples; ++v) EXPECT_NEAR(kappa[v], 0, 1e-9);
}

TEST(LevelSetCurvature, OfAConstantIsZero) {
  const Ball ball(1, 100);
  for (double k : level_set_curvature(ball.mesh, std::vector<double>(ball.mesh.points.size(), 2)))
    EXPECT_EQ(k, 0);
}

}  // namespace
}  // namespace arris
