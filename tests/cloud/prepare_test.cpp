#include "cloud/prepare.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "base/failure.h"
#include "base/vec.h"
#include "support/job.h"
#include "support/random.h"

namespace arris {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

Samples prepare(const std::vector<Vec3>& positions, NonFinite policy = NonFinite::refuse) {
  test::OneStageJob job;
  return prepare_samples(positions, policy, job);
}

Error failure_of(const std::vector<Vec3>& positions, NonFinite policy = NonFinite::refuse) {
  try {
    prepare(positions, policy);
  } catch (const Failure& f) {
    return f.error();
  }
  return {ErrorCode::internal, "no failure", ""};
}

std::array<std::uint64_t, 3> bits(Vec3 p) {
  return {std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
          std::bit_cast<std::uint64_t>(p.z)};
}

// offset + scale * [-1, 1]^3, coordinate by coordinate.
std::vector<Vec3> cloud_at(std::size_t n, double scale, Vec3 offset, std::uint64_t seed) {
  test::Random random(seed);
  const auto coordinate = [&](double o) { return o + scale * (2 * random.unit() - 1); };
  std::vector<Vec3> points(n);
  for (Vec3& p : points) p = {coordinate(offset.x), coordinate(offset.y), coordinate(offset.z)};
  return points;
}

std::vector<Vec3> ten_points() {
  return cloud_at(10, 1, {}, 1);
}

// Within [-bound, bound]^3, and every sample back at its input bit for bit.
bool is_exact(const std::vector<Vec3>& positions, double bound = 1) {
  const Samples samples = prepare(positions);
  bool good = std::frexp(samples.frame.scale, std::array<int, 1>{}.data()) == 0.5;
  for (std::size_t k = 0; k < samples.points.size(); ++k) {
    const Vec3 p = samples.points[k], user = positions[samples.source[k]];
    good &= samples.frame.to_user(p) == user && samples.frame.to_local(user) == p;
    good &= std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= bound;
  }
  return good && samples.points.size() + samples.duplicates == positions.size();
}

TEST(Prepare, KeepsEveryBitOfSurveyCoordinates) {
  EXPECT_TRUE(is_exact(cloud_at(500, 0.7, {}, 1)));
  EXPECT_TRUE(is_exact(cloud_at(500, 40, {500123.456, 5412345.678, 321.098}, 2)));  // UTM
  EXPECT_TRUE(is_exact(cloud_at(500, 0.5, {4027893.9, 307045.6, 4919474.9}, 3)));   // ECEF
  EXPECT_TRUE(is_exact(cloud_at(500, 3, {-2694045.1, -4293642.2, 3857878.3}, 4)));  // ECEF
  EXPECT_TRUE(is_exact(cloud_at(500, 1e-3, {5e6 + 0.1, 4e5 + 0.2, 100.3}, 5)));
}

TEST(Prepare, KeepsEveryBitAtTheEndsOfTheExponentRange) {
  EXPECT_TRUE(is_exact(cloud_at(500, 1e300, {}, 6)));
  EXPECT_TRUE(is_exact(cloud_at(500, 1e-300, {}, 7)));
  EXPECT_TRUE(is_exact(cloud_at(500, 1e300, {5e300, 0, -7e300}, 8)));
  EXPECT_TRUE(is_exact(cloud_at(500, 1.7e308, {}, 9), 8));
}

RC_GTEST_PROP(Prepare, IsExactAtAnyScaleAndOffset, ()) {
  const auto exponent = [](int from, int to) { return *rc::gen::inRange(from, to + 1); };
  const double scale = std::pow(10.0, exponent(-100, 100));
  Vec3 offset;
  for (double* o : {&offset.x, &offset.y, &offset.z})
    *o = *rc::gen::element(-1.0, 0.0, 1.0) * scale * std::pow(10.0, exponent(-3, 12));
  RC_ASSERT(is_exact(cloud_at(50, scale, offset, *rc::gen::arbitrary<std::uint64_t>())));
}

TEST(Prepare, MergesDuplicatesIntoTheFirst) {
  std::vector<Vec3> points = ten_points();
  points.insert(points.end(), {points[3], points[7], points[3]});
  const Samples samples = prepare(points);
  EXPECT_EQ(samples.points.size(), 10u);
  EXPECT_EQ(samples.duplicates, 3u);
  for (Index s : samples.source) EXPECT_LT(s, 10u);
}

TEST(Prepare, ZeroHasNoSign) {
  std::vector<Vec3> points = {{-0.0, 0, 0}, {0, -0.0, 0}, {0, 0, 0},   {1, 0, 0},
                              {0, 1, 0},    {0, 0, 1},    {1, -0.0, 0}};
  const Samples samples = prepare(points);
  EXPECT_EQ(samples.points.size(), 4u);
  EXPECT_EQ(samples.duplicates, 3u);
  for (Vec3 p : samples.points)
    for (double c : {p.x, p.y, p.z}) EXPECT_FALSE(c == 0 && std::signbit(c));
}

TEST(Prepare, RefusesNonFiniteNamingTheFirst) {
  for (double bad : {nan, inf, -inf}) {
    std::vector<Vec3> points = ten_points();
    points[6].y = bad;
    points[9].z = nan;
    const Error error = failure_of(points);
    EXPECT_EQ(error.code, ErrorCode::bad_points);
    EXPECT_NE(error.message.find("2 of 10"), std::string::npos) << error.message;
    EXPECT_NE(error.message.find("point 6"), std::string::npos) << error.message;
  }
}

TEST(Prepare, DropsNonFiniteAsIfTheyWereNotThere) {
  const std::vector<Vec3> clean = ten_points();
  std::vector<Vec3> points = clean;
  points.insert(points.begin() + 2, {nan, 0, 0});
  points.insert(points.begin() + 5, {0, inf, 0});
  const Samples samples = prepare(points, NonFinite::drop), wanted = prepare(clean);
  EXPECT_EQ(samples.non_finite, 2u);
  EXPECT_EQ(samples.points, wanted.points);
  for (std::size_t k = 0; k < wanted.source.size(); ++k)
    EXPECT_EQ(points[samples.source[k]], clean[wanted.source[k]]);
}

TEST(Prepare, TooFewPointsAreTypedFailures) {
  EXPECT_EQ(failure_of({}).code, ErrorCode::bad_points);
  EXPECT_EQ(failure_of({{nan, 0, 0}, {0, nan, 0}}, NonFinite::drop).code, ErrorCode::bad_points);
  EXPECT_EQ(failure_of({{1, 2, 3}}).code, ErrorCode::degenerate);
  EXPECT_EQ(failure_of({{1, 2, 3}, {2, 3, 4}, {3, 4, 6}}).code, ErrorCode::degenerate);
  EXPECT_EQ(failure_of(std::vector<Vec3>(50, {1, 2, 3})).code, ErrorCode::degenerate);
}

RC_GTEST_PROP(Prepare, IgnoresTheOrderOfThePoints, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  const auto n = *rc::gen::inRange<std::size_t>(10, 200);
  std::vector<Vec3> points = cloud_at(n, 3, {1e5 + 0.1, -7, 0}, seed);
  for (Vec3& p : points)  // many ties on a coarse grid
    if (random() % 2 == 0) p = {1e5 + std::floor(p.x - 1e5), std::floor(p.y), std::floor(p.z)};
  const Samples first = prepare(points);
  std::vector<Vec3> shuffled = points;
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  const Samples second = prepare(shuffled);
  RC_ASSERT(first.frame.shift == second.frame.shift);
  RC_ASSERT(first.frame.scale == second.frame.scale);
  RC_ASSERT(first.duplicates == second.duplicates);
  RC_ASSERT(first.points.size() == second.points.size());
  for (std::size_t k = 0; k < first.points.size(); ++k) {
    RC_ASSERT(bits(first.points[k]) == bits(second.points[k]));
    RC_ASSERT(points[first.source[k]] == shuffled[second.source[k]]);
  }
}

}  // namespace
}  // namespace arris
