// The predicates against rational arithmetic, where rounding, overflow and underflow would lie.
#include "tetra/predicates.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <random>

#include "base/vec.h"

namespace arris {
namespace {

using Rational = boost::multiprecision::cpp_rational;
struct Exact {
  Rational x, y, z;
};

Exact exact(Vec3 p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

Exact difference(Vec3 a, Vec3 b) {
  const Exact p = exact(a), q = exact(b);
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}

Exact exact_normal(Vec3 a, Vec3 b, Vec3 c) {
  const Exact u = difference(b, a), v = difference(c, a);
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

// The definition in the header: the side of abc to which (b-a) x (c-a) points.
int exact_orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Exact n = exact_normal(a, b, c), w = difference(d, a);
  return Rational(n.x * w.x + n.y * w.y + n.z * w.z).sign();
}

int exact_orient2d(Vec3 a, Vec3 b, Vec3 c, int axis) {
  const Exact n = exact_normal(a, b, c);
  return (axis == 0 ? n.x : axis == 1 ? n.y : n.z).sign();
}

void expect_exact(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  RC_ASSERT(orient3d(a, b, c, d) == exact_orient3d(a, b, c, d));
  bool flat = true;
  for (int axis = 0; axis < 3; ++axis) {
    const int sign = exact_orient2d(a, b, c, axis);
    RC_ASSERT(orient2d(a, b, c, axis) == sign);
    flat &= sign == 0;
  }
  RC_ASSERT(collinear(a, b, c) == flat);
}

TEST(Predicates, SignsOfTheHeader) {
  const Vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(orient3d(o, x, y, z), 1);  // x cross y points to z
  EXPECT_EQ(orient3d(o, y, x, z), -1);
  EXPECT_EQ(orient3d(o, x, y, x + y), 0);
  EXPECT_EQ(orient2d(o, y, z, 0), 1);
  EXPECT_EQ(orient2d(o, z, x, 1), 1);
  EXPECT_EQ(orient2d(o, x, y, 2), 1);
  EXPECT_EQ(orient2d(o, y, x, 2), -1);
  EXPECT_EQ(orient2d(o, x, z, 2), 0);
}

TEST(Predicates, CollinearPoints) {
  const Vec3 a{0.1, 0.2, 0.3}, b{0.7, -0.1, 5};
  EXPECT_TRUE(collinear(a, a, b));
  EXPECT_TRUE(collinear(a, b, b));
  EXPECT_TRUE(collinear(a, a, a));
  EXPECT_TRUE(collinear({1, 2, 3}, {2, 4, 6}, {-3, -6, -9}));
  EXPECT_FALSE(collinear({1, 2, 3}, {2, 4, 6}, {-3, -6, std::nextafter(-9, 0)}));
}

// One unit in the last place off a plane, far from zero.
TEST(Predicates, OneUlpOffThePlane) {
  const Vec3 a{1e7, 1e7, 1e7}, b{1e7 + 1, 1e7, 1e7 + 1}, c{1e7, 1e7 + 1, 1e7 + 1};
  const double z = 1e7 + 0.5;
  EXPECT_EQ(orient3d(a, b, c, {1e7 + 0.25, 1e7 + 0.25, z}), 0);
  EXPECT_EQ(orient3d(a, b, c, {1e7 + 0.25, 1e7 + 0.25, std::nextafter(z, 1e8)}), 1);
  EXPECT_EQ(orient3d(a, b, c, {1e7 + 0.25, 1e7 + 0.25, std::nextafter(z, 0)}), -1);
}

// Products of two underflow to a unit that the third factor makes large again.
TEST(Predicates, UnderflowTimesALargeFactor) {
  const double root = 0x1p-537;  // its square is the smallest double, to which 0.6 of it rounds
  const Vec3 a{0, -0.9 * root, 1.2e300}, b{root, 0, 1e300}, c{root, 0.6 * root, 0}, d{0, 0, 0};
  EXPECT_EQ(orient3d(a, b, c, d), exact_orient3d(a, b, c, d));
}

RC_GTEST_PROP(Predicates, AreExactOnRandomPoints, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  std::uniform_real_distribution<double> unit(-1, 1);
  const double scale = *rc::gen::element(1.0, 1e7, 1e-30, 1e150, 1e-150, 1e300, 1e-300);
  const auto point = [&] { return scale * Vec3{unit(random), unit(random), unit(random)}; };
  expect_exact(point(), point(), point(), point());
}

// Points rounded onto a plane or a line: signs come from the last bit.
RC_GTEST_PROP(Predicates, AreExactNextToDegenerate, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  std::uniform_real_distribution<double> unit(-1, 1);
  const double scale = *rc::gen::element(1.0, 1e7, 1e-30, 1e150, 1e-150);
  const bool line = *rc::gen::arbitrary<bool>();
  const Vec3 origin{unit(random), unit(random), unit(random)};
  const Vec3 u{unit(random), unit(random), unit(random)};
  const Vec3 v = line ? Vec3{} : Vec3{unit(random), unit(random), unit(random)};
  const auto point = [&] { return scale * (origin + unit(random) * u + unit(random) * v); };
  const Vec3 a = point(), b = point(), c = point();
  expect_exact(a, b, c, point());
  expect_exact(a, b, 0.5 * (a + b), c);
  expect_exact(a, a, b, c);
}

RC_GTEST_PROP(Predicates, AreExactOnALattice, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const double step = *rc::gen::element(1.0, 0.1, 1e100, 0x1p-1070);
  const auto coordinate = [&] { return step * (double(random() % 5) - 2); };
  const auto point = [&] { return Vec3{coordinate(), coordinate(), coordinate()}; };
  expect_exact(point(), point(), point(), point());
}

// Every magnitude a double can have, in one determinant.
RC_GTEST_PROP(Predicates, AreExactOnMixedMagnitudes, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  std::uniform_real_distribution<double> unit(-1, 1);
  const int lowest = *rc::gen::element(-1074, -600, -100),
            highest = *rc::gen::element(1023, 600, 0);
  std::uniform_int_distribution<int> exponent(lowest, highest);
  const auto coordinate = [&] {
    return random() % 4 == 0 ? 0.0 : std::ldexp(unit(random), exponent(random));
  };
  const auto point = [&] { return Vec3{coordinate(), coordinate(), coordinate()}; };
  expect_exact(point(), point(), point(), point());
}

RC_GTEST_PROP(Predicates, SwapTurnsTheSign, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&] { return Vec3{unit(random), unit(random), random() % 2 ? 0.5 : 0.25}; };
  const Vec3 a = point(), b = point(), c = point(), d = point();
  const int sign = orient3d(a, b, c, d);
  RC_ASSERT(orient3d(b, a, c, d) == -sign);
  RC_ASSERT(orient3d(a, c, b, d) == -sign);
  RC_ASSERT(orient3d(a, b, d, c) == -sign);
  RC_ASSERT(orient3d(b, c, a, d) == sign);
}

}  // namespace
}  // namespace arris
