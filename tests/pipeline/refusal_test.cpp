// Clouds that bound nothing, and clouds that only look as if they did not.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/clouds.h"
#include "support/random.h"

namespace arris {
namespace {

using namespace test;

ErrorCode outcome(std::vector<Vec3> positions, const Options& options = {}) {
  const Result<Reconstruction> r = reconstruct(cloud_of(std::move(positions)), options);
  EXPECT_TRUE(r || !r.error().message.empty());
  EXPECT_TRUE(r || !r.error().remedy.empty());
  return code_of(r);
}

void expect_refused(const std::vector<Vec3>& positions, ErrorCode code) {
  EXPECT_EQ(outcome(positions), code);
  EXPECT_EQ(outcome(positions, paper()), code);
}

TEST(Refusal, NoPoints) {
  expect_refused({}, ErrorCode::bad_points);
}

TEST(Refusal, TooFewPoints) {
  expect_refused({{1, 2, 3}}, ErrorCode::degenerate);
  expect_refused({{1, 2, 3}, {2, 3, 4}, {0, 0, 1}}, ErrorCode::degenerate);
}

TEST(Refusal, AllEqual) {
  expect_refused(std::vector<Vec3>(1000, {0.1, 0.2, 0.3}), ErrorCode::degenerate);
}

TEST(Refusal, AllOnOneLine) {
  std::vector<Vec3> points;
  for (int i = 0; i < 100; ++i) points.push_back({1.0 * i, 2.0 * i, -3.0 * i});
  expect_refused(points, ErrorCode::degenerate);
}

TEST(Refusal, AllInOnePlane) {
  Random random(1);
  std::vector<Vec3> flat, tilted;
  for (int i = 0; i < 200; ++i) {
    flat.push_back({random.unit(), random.unit(), 7});
    const double x = static_cast<double>(random.below(1000)),
                 y = static_cast<double>(random.below(1000));
    tilted.push_back({x, y, 2 * x - y});
  }
  expect_refused(flat, ErrorCode::degenerate);
  expect_refused(tilted, ErrorCode::degenerate);
}

TEST(Refusal, FourPointsAreATetrahedronOrNoSurface) {
  const ErrorCode code = outcome({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_TRUE(code == ErrorCode{} || code == ErrorCode::no_surface) << name(code);
}

// A solid grid: every cell of eight points is cospherical.
TEST(Refusal, CosphericalGridIsMeshedOrHasNoSurface) {
  std::vector<Vec3> grid;
  for (int i = 0; i < 512; ++i) grid.push_back({1.0 * (i % 8), 1.0 * (i / 8 % 8), 1.0 * (i / 64)});
  for (const Options& options : {Options{}, paper()}) {
    const ErrorCode code = outcome(grid, options);
    EXPECT_TRUE(code == ErrorCode{} || code == ErrorCode::no_surface) << name(code);
  }
}

// Not the samples of a surface at all.
TEST(Refusal, BallOfNoiseIsMeshedOrHasNoSurface) {
  Random random(2);
  std::vector<Vec3> ball;
  while (ball.size() < 2000) {
    const Vec3 p{2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1};
    if (squared_length(p) < 1) ball.push_back(p);
  }
  const ErrorCode code = outcome(ball);
  EXPECT_TRUE(code == ErrorCode{} || code == ErrorCode::no_surface) << name(code);
}

}  // namespace
}  // namespace arris
