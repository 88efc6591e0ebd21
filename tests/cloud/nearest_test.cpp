#include "cloud/nearest.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "base/vec.h"
#include "support/random.h"

namespace arris {
namespace {

double brute_force(const std::vector<Vec3>& points, Vec3 query) {
  double best = std::numeric_limits<double>::infinity();
  for (Vec3 p : points) best = std::min(best, distance(p, query));
  return best;
}

// Uniform, on a coarse grid (ties, coplanar rows), or in one tight cluster with an outlier.
std::vector<Vec3> points_of_kind(int kind, std::size_t n, test::Random& random) {
  std::vector<Vec3> points(n);
  for (Vec3& p : points) {
    p = {random.unit(), random.unit(), random.unit()};
    if (kind == 1) p = {std::floor(4 * p.x), std::floor(4 * p.y), 0};
    if (kind == 2) p = 1e-9 * p;
  }
  points[0] = {-1, -1, -1};
  return points;
}

RC_GTEST_PROP(NearestSample, AgreesWithBruteForce, (std::uint64_t seed)) {
  test::Random random(seed);
  const int kind = *rc::gen::inRange(0, 3);
  const auto n = *rc::gen::inRange<std::size_t>(1, 300);
  const std::vector<Vec3> points = points_of_kind(kind, n, random);
  const NearestSample nearest(points);
  for (int k = 0; k < 50; ++k) {
    const Vec3 query = 3 * Vec3{random.unit(), random.unit(), random.unit()} - Vec3{1, 1, 1};
    const NearestSample::Hit hit = nearest(query);
    RC_ASSERT(hit.index < n);
    const double best = brute_force(points, query);
    RC_ASSERT(std::abs(hit.distance - best) <= 1e-15 * best);
    RC_ASSERT(std::abs(distance(points[hit.index], query) - best) <= 1e-15 * best);
  }
  const std::size_t own = random.below(n);
  RC_ASSERT(nearest(points[own]).distance == 0);
  RC_ASSERT(points[nearest(points[own]).index] == points[own]);
}

RC_GTEST_PROP(NearestSample, FindsTheNearestFewInOrder, (std::uint64_t seed)) {
  test::Random random(seed);
  const int kind = *rc::gen::inRange(0, 3);
  const auto n = *rc::gen::inRange<std::size_t>(1, 300);
  const std::size_t k = 1 + random.below(40);
  const std::vector<Vec3> points = points_of_kind(kind, n, random);
  const NearestSample nearest(points);
  const Vec3 query = random.below(2) ? points[random.below(n)] : Vec3{random.unit(), 0.5, 0};
  std::vector<NearestSample::Hit> expected, hits;
  for (Index i = 0; i < n; ++i) expected.push_back({i, distance(query, points[i])});
  std::sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
  });
  nearest.nearest(query, k, hits);
  RC_ASSERT(hits.size() == std::min(k, n));
  for (std::size_t j = 0; j < hits.size(); ++j) {
    RC_ASSERT(hits[j].distance == expected[j].distance);  // of equally far ones any may be last
    RC_ASSERT(distance(query, points[hits[j].index]) == hits[j].distance);
    if (j == 0) continue;
    const bool in_order =
        hits[j - 1].distance < hits[j].distance || hits[j - 1].index < hits[j].index;
    RC_ASSERT(in_order);
  }
}

TEST(NearestSample, DuplicatesAndDensePlacesAreFound) {
  test::Random random(5);
  std::vector<Vec3> points(5000, Vec3{0.25, 0.25, 0.25});
  for (std::size_t i = 1000; i < points.size(); ++i)
    points[i] = 1e-8 * Vec3{random.unit(), random.unit(), random.unit()};
  const NearestSample nearest(points);
  EXPECT_LT(nearest({1, 1, 1}).index, 1000u);
  for (int k = 0; k < 100; ++k) {
    const Vec3 query = 1e-8 * Vec3{random.unit(), random.unit(), random.unit()};
    EXPECT_EQ(nearest(query).distance, brute_force(points, query));
  }
}

}  // namespace
}  // namespace arris
