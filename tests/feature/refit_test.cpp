#include "feature/refit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "feature/rough_surface.h"
#include "support/known_solids.h"

namespace arris {
namespace {

using namespace test;

double box_off(Vec3 p) {
  return box_distance(p, 0, 1);
}

bool is_near_edge(Vec3 p, double far) {
  const auto wall = [](double x) { return std::min(std::abs(x), std::abs(1 - x)); };
  const double x = wall(p.x), y = wall(p.y), z = wall(p.z);
  return std::max({std::min(x, y), std::min(y, z), std::min(z, x)}) < far;
}

// The mean of `value` over the points for which `counts` is true of the clean sample.
double mean(
    const RoughSurface& rough, const std::vector<Vec3>& points,
    const std::function<double(Vec3)>& value,
    const std::function<bool(Vec3)>& counts = [](Vec3) { return true; }) {
  double sum = 0, count = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!counts(rough.clean.vertices[v])) continue;
    sum += value(points[v]);
    count += 1;
  }
  return sum / count;
}

TEST(Refit, SamplesOfAPolyhedronGoToItsFaces) {
  const RoughSurface rough(cube(), 4000, 0.25);
  const auto off = [](Vec3 p) { return std::abs(box_off(p)); };
  const double refitted = mean(rough, rough.refitted(), off);
  EXPECT_LT(refitted, 0.15 * rough.sigma);
  EXPECT_LT(refitted, 0.7 * mean(rough, rough.settled(), off));
}

TEST(Refit, SamplesBesideAnEdgeDoNotSink) {
  const RoughSurface rough(cube(), 4000, 0.25);
  const auto beside = [&](Vec3 p) { return is_near_edge(p, 2 * rough.h); };
  EXPECT_NEAR(mean(rough, rough.refitted(), box_off, beside), 0, 0.05 * rough.sigma);
}

TEST(Refit, SamplesOfARoundSolidDoNotSink) {
  const RoughSurface rough(sphere(), 4000, 0.25);
  const std::vector<Vec3> refitted = rough.refitted();
  const auto off = [](Vec3 p) { return length(p) - 1; };
  EXPECT_LT(mean(rough, refitted, [&](Vec3 p) { return std::abs(off(p)); }), 0.3 * rough.sigma);
  EXPECT_NEAR(mean(rough, refitted, off), 0, 0.1 * rough.sigma);
}

TEST(Refit, SheetsOfAThinPlateStayApart) {
  const RoughSurface rough(thin_plate(), 6000, 0.25);
  EXPECT_EQ(rough.crossed(rough.refitted()), 0u);
}

TEST(Refit, PointsWithoutNoiseStayAndHaveNoSay) {
  RoughSurface rough(cube(), 4000, 0.25);
  std::vector<Vec3> measured = rough.points;
  for (std::size_t v = 0; v < measured.size(); v += 10) {  // feature points, say, badly placed
    rough.level[v] = 0;
    measured[v] = measured[v] + Vec3{0, 0, 3 * rough.sigma};
  }
  const auto refit = [&](const std::vector<Vec3>& places) {
    OneStageJob job(1);
    return refit_samples({rough.points, places, rough.backing, rough.level, rough.spacing},
                         rough.facets, job);
  };
  const std::vector<Vec3> refitted = refit(measured);
  EXPECT_EQ(refitted, refit(rough.points));  // bit for bit
  for (std::size_t v = 0; v < refitted.size(); v += 10) EXPECT_EQ(refitted[v], rough.points[v]);
}

TEST(Refit, ThreadsDoNotChangeABit) {
  const RoughSurface rough(two_cubes(), 6000, 0.2);
  EXPECT_EQ(rough.refitted(1), rough.refitted(4));
}

}  // namespace
}  // namespace arris
