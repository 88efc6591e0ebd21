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

}  // namespace
}  // namespace arris
