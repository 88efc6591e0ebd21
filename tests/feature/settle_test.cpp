#include "feature/settle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "feature/rough_surface.h"
#include "support/known_solids.h"

namespace arris {
namespace {

using namespace test;

double mean(const std::vector<Vec3>& points, const std::function<double(Vec3)>& value) {
  double sum = 0;
  for (Vec3 p : points) sum += value(p);
  return sum / static_cast<double>(points.size());
}

TEST(Settle, SamplesOfAPolyhedronGoToItsFaces) {
  const RoughSurface rough(cube(), 4000, 0.15);
  const auto off = [](Vec3 p) { return std::abs(box_distance(p, 0, 1)); };
  EXPECT_GT(mean(rough.points, off), 0.7 * rough.sigma);
  EXPECT_LT(mean(rough.settled(), off), 0.3 * rough.sigma);
}

TEST(Settle, SamplesOfARoundSolidDoNotSink) {
  const RoughSurface rough(sphere(), 4000, 0.15);
  const std::vector<Vec3> settled = rough.settled();
  EXPECT_LT(mean(settled, [](Vec3 p) { return std::abs(length(p) - 1); }), 0.3 * rough.sigma);
  // Means over neighbours as they lie would sink by 1.6 h², a sixth of this.
  EXPECT_NEAR(mean(settled, [](Vec3 p) { return length(p) - 1; }), 0, 0.1 * rough.sigma);
}

TEST(Settle, SheetsOfAThinPlateStayApart) {
  const RoughSurface rough(thin_plate(), 6000, 0.2);
  EXPECT_EQ(rough.crossed(rough.settled()), 0u);
}

TEST(Settle, WithoutNoiseNothingMoves) {
  RoughSurface rough(two_cubes(), 3000, 0.1);
  std::fill(rough.level.begin(), rough.level.end(), 0);
  EXPECT_EQ(rough.settled(), rough.points);  // bit for bit
}

// The mean height of samples on the top of a cube, off its edges, that were measured half a
// deviation above where they are, in deviations.
double risen(double backing) {
  const RoughSurface rough(cube(), 3000, 0.05);
  const std::vector<Vec3>& present = rough.clean.vertices;
  std::vector<Vec3> measured = present;
  for (Vec3& p : measured) p = p + 0.5 * rough.sigma * Vec3{1, 1, 1};
  const std::vector<double> backed(present.size(), backing);
  OneStageJob job(1);
  const std::vector<Vec3> settled =
      settle_samples({present, measured, backed, rough.level, rough.spacing}, rough.facets, job);
  double sum = 0, count = 0;
  for (std::size_t v = 0; v < settled.size(); ++v) {
    const Vec3 p = present[v];
    if (p.z < 1 - 1e-9 || std::min({p.x, p.y, 1 - p.x, 1 - p.y}) < 0.2) continue;
    sum += settled[v].z - 1;
    count += 1;
  }
  EXPECT_GT(count, 50);
  return sum / count / rough.sigma;
}

TEST(Settle, MeasuredPlacesCountAsFarAsPresentOnesAreNotBacked) {
  const double unbacked = risen(0), backed = risen(100);
  EXPECT_NEAR(unbacked, 0.5, 0.15);
  EXPECT_LT(backed, 0.7 * unbacked);
  EXPECT_GT(backed, 0.2 * unbacked);
  EXPECT_NEAR(risen(1e6), 0, 0.01);
}

TEST(Settle, ThreadsDoNotChangeABit) {
  const RoughSurface rough(two_cubes(), 6000, 0.15);
  EXPECT_EQ(rough.settled(1), rough.settled(4));
}

}  // namespace
}  // namespace arris
