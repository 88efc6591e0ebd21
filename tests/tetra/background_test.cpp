#include "tetra/background.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/vec.h"
#include "cloud/prepare.h"
#include "support/samplers.h"
#include "support/shapes.h"
#include "support/tetra.h"

namespace arris {
namespace {

// As in background.cpp.
constexpr double clearance = 0.9;

struct Prepared {
  Samples samples;
  std::vector<double> spacing;

  explicit Prepared(const std::vector<Vec3>& positions) {
    test::OneStageJob job;
    samples = prepare_samples(positions, NonFinite::refuse, job);
    spacing = test::Measured(samples.points).spacing;
  }
  Background background(double per_sample) const {
    test::OneStageJob job;
    return background_points(samples.points, spacing, samples.frame, per_sample, job);
  }
};

std::vector<Vec3> torus_at(Vec3 offset, std::size_t n = 400) {
  std::vector<Vec3> points = test::sample_blue(test::torus().mesh, n, 1);
  for (Vec3& p : points) p = p + offset;
  return points;
}

TEST(Background, KeepsClearOfTheSamplesAndKnowsTheNearest) {
  const Prepared torus(torus_at({}));
  const Background background = torus.background(10);
  ASSERT_EQ(background.points.size(), background.nearest.size());
  for (std::size_t k = 0; k < background.points.size(); ++k) {
    const Vec3 p = background.points[k];
    double best = distance(p, torus.samples.points[0]);
    for (Vec3 s : torus.samples.points) best = std::min(best, distance(p, s));
    const Index near = background.nearest[k];
    EXPECT_NEAR(distance(p, torus.samples.points[near]), best, 1e-12);
    EXPECT_GE(best, clearance * torus.spacing[near] * (1 - 1e-12));
  }
}

TEST(Background, CountIsOfTheOrderAskedFor) {
  const Prepared torus(torus_at({}));
  EXPECT_TRUE(torus.background(0).points.empty());
  for (double per_sample : {1.0, 10.0, 50.0}) {
    const double count = static_cast<double>(torus.background(per_sample).points.size()) / 400;
    EXPECT_GT(count, 0.4 * per_sample);
    EXPECT_LT(count, 2 * per_sample);
  }
}

TEST(Background, SurroundsTheSamples) {
  const Prepared torus(torus_at({}));
  std::vector<Vec3> all = torus.samples.points;
  const Background background = torus.background(10);
  all.insert(all.end(), background.points.begin(), background.points.end());
  const TetMesh mesh = test::delaunay_of(all);
  for (Tet t = static_cast<Tet>(mesh.finite); t < mesh.size(); ++t)
    for (Index v : mesh.vertices[t]) EXPECT_GE(v, 400u);  // background or infinite
}

TEST(Background, IsTheSameEveryTime) {
  const Prepared torus(torus_at({}));
  const Background first = torus.background(10), second = torus.background(10);
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.nearest, second.nearest);
}

void expect_exact_and_distinct(const Prepared& cloud) {
  Background background = cloud.background(10);
  EXPECT_FALSE(background.points.empty());
  for (Vec3 p : background.points)
    EXPECT_EQ(cloud.samples.frame.to_local(cloud.samples.frame.to_user(p)), p);
  std::vector<Vec3>& points = background.points;
  std::sort(points.begin(), points.end(), lexicographic_less);
  EXPECT_EQ(std::adjacent_find(points.begin(), points.end()), points.end());
}

TEST(Background, IsExactInTheUsersFrame) {
  expect_exact_and_distinct(Prepared(torus_at({})));
  expect_exact_and_distinct(Prepared(torus_at({5e6 + 0.1, 4e5 + 0.2, 100.3})));
}

// Where the user's doubles are as far apart as the samples, few points fit between them.
TEST(Background, IsDistinctWhereTheUsersFrameIsCoarse) {
  std::vector<Vec3> positions;
  for (int i = 0; i < 512; ++i)
    if (i % 8 % 7 == 0 || i / 8 % 8 % 7 == 0 || i / 64 % 7 == 0)
      positions.push_back({0x1p53 + 2 * (i % 8), 0x1p53 + 2 * (i / 8 % 8), 0x1p53 + 2 * (i / 64)});
  expect_exact_and_distinct(Prepared(positions));
}

TEST(Background, NearestOfAllPoints) {
  Background background;
  background.points = {{0, 0, 0}, {1, 1, 1}};
  background.nearest = {2, 0};
  EXPECT_EQ(nearest_samples(3, background), (std::vector<Index>{0, 1, 2, 2, 0}));
}

}  // namespace
}  // namespace arris
