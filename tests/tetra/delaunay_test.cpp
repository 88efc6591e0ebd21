#include "tetra/delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "base/failure.h"
#include "base/vec.h"
#include "tetra/predicates.h"

namespace arris {
namespace {

std::vector<Vec3> random_points(std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec3> points(n);
  for (Vec3& p : points) p = {unit(random), unit(random), unit(random)};
  return points;
}

TetMesh build(const std::vector<Vec3>& points) {
  const Context context;
  Job job(context);
  job.stage("delaunay", 1);
  return delaunay(points, points.size(), job);
}

TEST(Delaunay, IsAClosedTriangulationOfSpace) {
  const TetMesh mesh = build(random_points(500, 1));
  for (Tet t = 0; t < mesh.size(); ++t) {
    int infinite = 0;
    for (Index v : mesh.vertices[t]) infinite += v == infinite_vertex;
    EXPECT_EQ(infinite, mesh.is_finite(t) ? 0 : 1);
    for (Tet n : mesh.neighbours[t])
      EXPECT_EQ(mesh.neighbours[n][static_cast<std::size_t>(mesh.facet_to(n, t))], t);
    if (mesh.is_finite(t)) {
      const auto& v = mesh.vertices[t];
      EXPECT_EQ(
          orient3d(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]), 1);
    }
  }
}

// Corners of the finite tetrahedra, each and all sorted.
std::vector<std::array<Index, 4>> sorted_corners(const TetMesh& mesh) {
  std::vector<std::array<Index, 4>> all(
      mesh.vertices.begin(), mesh.vertices.begin() + static_cast<std::ptrdiff_t>(mesh.finite));
  for (auto& corners : all) std::sort(corners.begin(), corners.end());
  std::sort(all.begin(), all.end());
  return all;
}

// Of a grid, too, where everything is cospherical.
TEST(Delaunay, AddedPointsGiveTheSameAsAllAtOnce) {
  std::vector<Vec3> grid;
  for (int i = 0; i < 216; ++i) grid.push_back({i % 6 / 8.0, i / 6 % 6 / 8.0, i / 36 / 8.0});
  for (const auto& points : {random_points(400, 2), grid}) {
    std::vector<Vec3> added = random_points(60, 3);
    added.push_back({0.0625, 0.125, 0.25});  // on a line of the grid
    added.push_back({2, -1, 0.5});           // outside the hull
    std::vector<Index> near(added.size());
    for (std::size_t k = 0; k < near.size(); ++k) near[k] = static_cast<Index>(3 * k);
    const TetMesh before = build(points);
    const Context context;
    Job job(context);
    job.stage("delaunay", 1);
    const auto [mesh, former] = add_points(before, added, near, job);
    std::vector<Vec3> all = points;
    all.insert(all.end(), added.begin(), added.end());
    EXPECT_EQ(sorted_corners(mesh), sorted_corners(build(all)));
    EXPECT_EQ(mesh.points, all);
    EXPECT_EQ(mesh.samples, all.size());
    ASSERT_EQ(former.size(), mesh.size());
    std::size_t kept = 0;
    for (Tet t = 0; t < mesh.size(); ++t) {
      for (std::size_t i = 0; i < 4; ++i) {
        const Tet n = mesh.neighbours[t][i];
        EXPECT_EQ(mesh.neighbours[n][static_cast<std::size_t>(mesh.facet_to(n, t))], t);
      }
      kept += former[t] != no_tet;
      if (former[t] == no_tet) continue;
      EXPECT_EQ(before.vertices[former[t]], mesh.vertices[t]);
    }
    EXPECT_GT(kept, mesh.size() / 4);
  }
}

// Twice on one point of the mesh, and on each other.
TEST(Delaunay, AnAddedPointTakesThePlaceOfAnother) {
  const std::vector<Vec3> points = random_points(100, 4);
  const TetMesh before = build(points);
  const Vec3 fresh{0.5, 0.25, 0.75};
  const Context context;
  Job job(context);
  job.stage("delaunay", 1);
  const TetMesh mesh =
      add_points(before, {points[7], fresh, points[7], fresh, points[9]}, {7, 3, 20, 3, 8}, job)
          .mesh;
  std::vector<Vec3> all = points;
  all.push_back(fresh);
  auto expected = sorted_corners(build(all));
  for (auto& corners : expected) {
    for (Index& v : corners) v = v == 7 ? 102 : v == 9 ? 104 : v == 100 ? 103 : v;
    std::sort(corners.begin(), corners.end());
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(sorted_corners(mesh), expected);
  for (Tet t = 0; t < mesh.size(); ++t)
    for (Tet n : mesh.neighbours[t])
      EXPECT_EQ(mesh.neighbours[n][static_cast<std::size_t>(mesh.facet_to(n, t))], t);
}

TEST(Delaunay, FlatPointsAreATypedFailure) {
  const std::vector<Vec3> flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 3, 0}};
  try {
    build(flat);
    FAIL();
  } catch (const Failure& f) {
    EXPECT_EQ(f.error().code, ErrorCode::degenerate);
  }
}

}  // namespace
}  // namespace arris
