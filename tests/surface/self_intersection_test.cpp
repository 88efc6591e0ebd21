// The search for intersecting pairs where triangles are crowded: needles, and fans round one
// vertex.
#include "surface/self_intersection.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "base/vec.h"
#include "support/job.h"
#include "support/random.h"
#include "surface/triangle_intersection.h"
#include "tetra/predicates.h"

namespace arris {
namespace {

using test::OneStageJob;
using test::Random;

Intersections find(const Mesh& mesh, const CrowdLimits& limits = {}, unsigned threads = 1) {
  OneStageJob job(threads);
  std::vector<Index> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), Index{0});
  const BoxTree tree(mesh.vertices, mesh.triangles, all, measuring_frame(mesh.vertices), threads);
  return find_intersections(mesh.vertices, mesh.triangles, tree, job, 0, limits);
}

// All pairs, one by one.
Defects all_pairs(const Mesh& mesh) {
  Defects pairs;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (Index u = t + 1; u < mesh.triangles.size(); ++u)
      if (facets_meet(make_facet(mesh.vertices, mesh.triangles[t]),
                      make_facet(mesh.vertices, mesh.triangles[u])))
        pairs.add(t, u);
  return pairs;
}

// Drops degenerate triangles.
void add_triangle(Mesh& mesh, Index a, Index b, Index c) {
  if (a == b || b == c || c == a) return;
  if (!collinear(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]))
    mesh.triangles.push_back({a, b, c});
}

// Two tips over and under a ring of n: vertices 0 .. n - 1, then the tips.
Mesh bipyramid(Index n) {
  Mesh mesh;
  for (Index k = 0; k < n; ++k) {
    const double a = 2 * std::numbers::pi * k / n;
    mesh.vertices.push_back({std::cos(a), std::sin(a), 0});
  }
  mesh.vertices.push_back({0.1, 0.2, 1});
  mesh.vertices.push_back({0, 0.1, -1.3});
  for (Index k = 0; k < n; ++k) {
    mesh.triangles.push_back({k, (k + 1) % n, n});
    mesh.triangles.push_back({(k + 1) % n, k, n + 1});
  }
  return mesh;
}

// The side of a long prism, and the tips of flat fans that close it.
Mesh prism(Index n) {
  Mesh mesh;
  for (double z : {-5.0, 5.0})
    for (Index k = 0; k < n; ++k) {
      const double a = 2 * std::numbers::pi * k / n;
      mesh.vertices.push_back({std::cos(a), std::sin(a), z});
    }
  mesh.vertices.push_back({0, 0, -5});
  mesh.vertices.push_back({0, 0, 5});
  for (Index k = 0; k < n; ++k) {
    const Index l = (k + 1) % n;
    mesh.triangles.push_back({k, l, n + l});
    mesh.triangles.push_back({k, n + l, n + k});
    mesh.triangles.push_back({l, k, 2 * n});
    mesh.triangles.push_back({n + k, n + l, 2 * n + 1});
  }
  return mesh;
}

// Turned so that no side lies along an axis, and the boxes of needles overlap each other.
Mesh turned(Mesh mesh) {
  for (Vec3& p : mesh.vertices) {
    const Vec3 q{0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y, p.z};
    p = {q.x, 0.6 * q.y - 0.8 * q.z, 0.8 * q.y + 0.6 * q.z};
  }
  return mesh;
}

void expect_all_pairs(const Mesh& mesh, const CrowdLimits& limits = {}) {
  const Intersections found = find(mesh, limits);
  const Defects expected = all_pairs(mesh);
  EXPECT_EQ(found.pairs.count, expected.count);
  EXPECT_EQ(found.pairs.example, expected.example);
}

// Points of a small lattice, of which a few are corners of many triangles: touching, coplanar and
// equal triangles, and tips seen from all sides, all the time.
RC_GTEST_PROP(Intersections, OfACrowdAreThoseOfAllPairs, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  Mesh mesh;
  const auto size = static_cast<std::size_t>(*rc::gen::inRange(2, 6));
  const auto points = static_cast<std::size_t>(*rc::gen::inRange(4, 30));
  const bool is_exact = *rc::gen::arbitrary<bool>();
  for (std::size_t k = 0; k < points; ++k) {
    const auto at = [&] {
      const auto x = static_cast<double>(random.below(size));
      return is_exact ? x : x + 1e-15 * random.between(-1, 1);
    };
    mesh.vertices.push_back({at(), at(), at()});
  }
  const int triangles = *rc::gen::inRange(2, 60);
  for (int t = 0; t < triangles; ++t) {
    const auto any = [&](std::size_t n) { return static_cast<Index>(random.below(n)); };
    add_triangle(mesh, any(random.below(2) == 0 ? 2 : points), any(points), any(points));
  }
  const CrowdLimits limits{static_cast<std::size_t>(*rc::gen::inRange(0, 12)),
                           static_cast<std::size_t>(*rc::gen::inRange(1, 6))};
  const Intersections found = find(mesh, limits);
  const Defects expected = all_pairs(mesh);
  RC_ASSERT(found.pairs.count == expected.count);
  RC_ASSERT(found.pairs.example == expected.example);
}

TEST(Intersections, SoundFansAndNeedlesHaveNone) {
  for (const Mesh& mesh : {bipyramid(700), turned(bipyramid(700)), prism(500), turned(prism(500))})
    EXPECT_EQ(find(mesh).pairs.count, 0u);
}

TEST(Intersections, OfAFoldedFanAreFound) {
  Mesh mesh = turned(bipyramid(400));
  std::swap(mesh.vertices[100], mesh.vertices[101]);
  EXPECT_GT(find(mesh).pairs.count, 0u);
  expect_all_pairs(mesh);
}

TEST(Intersections, OfFanTrianglesFarFromEachOtherInTheFanAreFound) {
  Mesh mesh = turned(bipyramid(400));
  // Half way round the ring, and beyond the tips' axis.
  const Vec3 opposite = mesh.vertices[300] - mesh.vertices[100];
  mesh.vertices[100] = mesh.vertices[100] + 1.02 * opposite;
  EXPECT_GT(find(mesh).pairs.count, 0u);
  expect_all_pairs(mesh);
}

TEST(Intersections, OfNeedlesAreFound) {
  Mesh mesh = prism(300);
  mesh.vertices[10] = mesh.vertices[200];
  mesh.vertices[10].x += 1e-9;
  EXPECT_GT(find(turned(mesh)).pairs.count, 0u);
  expect_all_pairs(turned(mesh));
}

// A triangle that touches another in a ray from the tip alone, but for the last bit.
TEST(Intersections, TouchingAtTheTipIsToldFromPassingByBitForBit) {
  Mesh mesh;
  const Index tip = 0;
  mesh.vertices.push_back({0, 0, 0});
  constexpr Index n = 200;  // a row of triangles over the plane y = 1, far to the right
  for (Index k = 0; k <= n; ++k) mesh.vertices.push_back({4 + k / 64.0, 1, 0.5});
  for (Index k = 0; k < n; ++k) mesh.triangles.push_back({tip, k + 1, k + 2});
  mesh.vertices.push_back({0, 3, 0.75});
  const auto lone = static_cast<Index>(mesh.vertices.size());
  mesh.vertices.push_back({12, 3, 1.5});  // on the ray through {4, 1, 0.5}
  mesh.triangles.push_back({tip, lone - 1, lone});
  EXPECT_EQ(find(mesh, {16, 8}).pairs.count, 1u);
  expect_all_pairs(mesh, {16, 8});
  mesh.vertices[lone].x = std::nextafter(12.0, 0.0);
  EXPECT_EQ(find(mesh, {16, 8}).pairs.count, 0u);
  mesh.vertices[lone].x = std::nextafter(12.0, 13.0);
  EXPECT_EQ(find(mesh, {16, 8}).pairs.count, all_pairs(mesh).count);
}

// Arcs of nearly half a turn, tips far from the origin, and coordinates that leave no room for
// products.
TEST(Intersections, OfExtremeFansAreThoseOfAllPairs) {
  const Mesh fan = bipyramid(60);
  for (const double scale : {1e-300, 1e-160, 1e160, 1e300}) {
    Mesh mesh = fan;
    std::swap(mesh.vertices[20], mesh.vertices[21]);
    for (Vec3& p : mesh.vertices) p = scale * p;
    expect_all_pairs(mesh, {4, 4});
  }
  Mesh wide;
  wide.vertices.push_back({1e6, 1e6, 1e6});
  for (int k = 0; k < 40; ++k) {  // zigzag
    const double side = k % 2 == 0 ? -1 : 1;
    wide.vertices.push_back(wide.vertices[0] + Vec3{side * 1024, k / 16.0, 1.0 + k % 3});
    if (k > 0) add_triangle(wide, 0, static_cast<Index>(k), static_cast<Index>(k + 1));
  }
  expect_all_pairs(wide, {2, 2});
}

// Pairs asked for exactly, a triangle: the search does the less work the fewer there are.
double tested_each(const Mesh& mesh) {
  return static_cast<double>(find(mesh).tested) / static_cast<double>(mesh.triangles.size());
}

TEST(Intersections, AreSoughtAmongAFewPairsATriangleWhateverTheFan) {
  for (const Index n : {1000u, 8000u}) {
    EXPECT_LT(tested_each(bipyramid(n)), 40);
    EXPECT_LT(tested_each(turned(bipyramid(n))), 40);
    EXPECT_LT(tested_each(prism(n)), 40);
    EXPECT_LT(tested_each(turned(prism(n))), 40);
  }
}

TEST(Intersections, DoNotDependOnThreads) {
  Mesh mesh = turned(bipyramid(3000));
  std::swap(mesh.vertices[20], mesh.vertices[21]);
  const Intersections one = find(mesh, {}, 1), four = find(mesh, {}, 4);
  EXPECT_EQ(one.pairs.count, four.pairs.count);
  EXPECT_EQ(one.pairs.example, four.pairs.example);
  EXPECT_EQ(one.tested, four.tested);
}

}  // namespace
}  // namespace arris
