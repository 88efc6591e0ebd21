#include "tetra/delaunay.h"

#include <gtest/gtest.h>

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
