// The Delaunay property on small integer points, where determinants are exact in 64 bits.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include "base/failure.h"
#include "base/vec.h"
#include "support/tetra.h"
#include "tetra/predicates.h"

namespace arris {
namespace {

using Whole = std::int64_t;

struct WholeVec {
  Whole x, y, z;
};
WholeVec between(Vec3 a, Vec3 b) {
  return {static_cast<Whole>(b.x - a.x), static_cast<Whole>(b.y - a.y),
          static_cast<Whole>(b.z - a.z)};
}
Whole det(WholeVec a, WholeVec b, WholeVec c) {
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) +
         a.z * (b.x * c.y - b.y * c.x);
}
Whole squared(WholeVec a) {
  return a.x * a.x + a.y * a.y + a.z * a.z;
}

// Six times the volume: positive if (a, b, c, d) is positively oriented.
Whole volume6(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  return det(between(a, b), between(a, c), between(a, d));
}

// p lies strictly inside the circumsphere of the positively oriented tetrahedron: the point lifted
// to the paraboloid lies below the plane through the lifted corners.
bool in_sphere(const std::array<Vec3, 4>& corner, Vec3 p) {
  std::array<WholeVec, 4> v;
  std::array<Whole, 4> lift;
  for (std::size_t k = 0; k < 4; ++k) {
    v[k] = between(p, corner[k]);
    lift[k] = squared(v[k]);
  }
  const Whole sum = lift[0] * det(v[1], v[2], v[3]) - lift[1] * det(v[0], v[2], v[3]) +
                    lift[2] * det(v[0], v[1], v[3]) - lift[3] * det(v[0], v[1], v[2]);
  return sum > 0;
}

std::array<Vec3, 4> corners(const TetMesh& mesh, Tet t) {
  const auto& v = mesh.vertices[t];
  return {mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]};
}

std::vector<Vec3> distinct_grid_points(std::size_t n, std::size_t side, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto coordinate = [&] { return static_cast<double>(random() % side); };
  std::vector<Vec3> points(n);
  for (Vec3& p : points) p = {coordinate(), coordinate(), coordinate()};
  std::sort(points.begin(), points.end(), lexicographic_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

// The tetrahedra as sets of coordinates.
using PointSet = std::set<std::array<std::array<double, 3>, 4>>;
PointSet tetrahedra_of(const TetMesh& mesh) {
  PointSet all;
  for (Tet t = 0; t < mesh.finite; ++t) {
    std::array<std::array<double, 3>, 4> key;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec3 p = mesh.points[mesh.vertices[t][k]];
      key[k] = {p.x, p.y, p.z};
    }
    std::sort(key.begin(), key.end());
    all.insert(key);
  }
  return all;
}

TEST(DelaunayOracle, InSphereKnowsTheUnitCube) {
  const std::array<Vec3, 4> t = {Vec3{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  EXPECT_GT(volume6(t[0], t[1], t[2], t[3]), 0);
  EXPECT_TRUE(in_sphere(t, {1, 1, 1}));
  EXPECT_FALSE(in_sphere(t, {2, 2, 2}));  // on it
  EXPECT_FALSE(in_sphere(t, {3, 0, 0}));
}

RC_GTEST_PROP(DelaunayOracle, CircumspheresAreEmptyAndFillAConvexHull, (std::uint64_t seed)) {
  const auto side = *rc::gen::element<std::size_t>(3, 4, 8, 100);
  const auto n = *rc::gen::inRange<std::size_t>(5, 60);
  TetMesh mesh;
  try {
    mesh = test::delaunay_of(distinct_grid_points(n, side, seed));
  } catch (const Failure&) {
    RC_DISCARD("flat");
  }
  std::set<Index> used;
  for (Tet t = 0; t < mesh.finite; ++t) {
    const std::array<Vec3, 4> c = corners(mesh, t);
    RC_ASSERT(volume6(c[0], c[1], c[2], c[3]) > 0);
    for (Vec3 p : mesh.points) RC_ASSERT(!in_sphere(c, p));
    used.insert(mesh.vertices[t].begin(), mesh.vertices[t].end());
  }
  RC_ASSERT(used.size() == mesh.points.size());
  for (Tet t = static_cast<Tet>(mesh.finite); t < mesh.size(); ++t) {
    const auto& v = mesh.vertices[t];
    const auto i =
        static_cast<std::size_t>(std::find(v.begin(), v.end(), infinite_vertex) - v.begin());
    const Tet inner = mesh.neighbours[t][i];
    const auto& k = facet_corners[static_cast<std::size_t>(mesh.facet_to(inner, t))];
    const auto at = [&](int c) {
      return mesh.points[mesh.vertices[inner][static_cast<std::size_t>(c)]];
    };
    for (Vec3 p : mesh.points) RC_ASSERT(volume6(at(k[0]), at(k[1]), at(k[2]), p) <= 0);
  }
}

RC_GTEST_PROP(DelaunayOracle, IgnoresTheOrderOfThePoints, (std::uint64_t seed)) {
  const auto side = *rc::gen::element<std::size_t>(3, 4, 8, 100);
  std::vector<Vec3> points = distinct_grid_points(80, side, seed);
  std::vector<Vec3> other = points;
  std::shuffle(other.begin(), other.end(), std::mt19937_64(seed + 1));
  RC_ASSERT(tetrahedra_of(test::delaunay_of(points)) == tetrahedra_of(test::delaunay_of(other)));
}

TEST(DelaunayOracle, ACosphericalGridIgnoresTheOrder) {
  std::vector<Vec3> points;
  for (int i = 0; i < 216; ++i)
    points.push_back({1.0 * (i % 6), 1.0 * (i / 6 % 6), 1.0 * (i / 36)});
  const TetMesh first = test::delaunay_of(points);
  Whole volume = 0;
  for (Tet t = 0; t < first.finite; ++t) {
    const std::array<Vec3, 4> c = corners(first, t);
    EXPECT_GT(volume6(c[0], c[1], c[2], c[3]), 0);
    volume += volume6(c[0], c[1], c[2], c[3]);
  }
  EXPECT_EQ(volume, 6 * 125);
  for (unsigned seed = 1; seed < 5; ++seed) {
    std::shuffle(points.begin(), points.end(), std::mt19937_64(seed));
    EXPECT_EQ(tetrahedra_of(first), tetrahedra_of(test::delaunay_of(points)));
  }
}

}  // namespace
}  // namespace arris
