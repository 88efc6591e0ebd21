#include "tetra/locate.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/vec.h"
#include "support/random.h"
#include "support/tetra.h"
#include "tetra/predicates.h"

namespace arris {
namespace {

bool holds(const TetMesh& mesh, Tet t, Vec3 p) {
  const auto& v = mesh.vertices[t];
  for (const auto& k : facet_corners) {
    const auto at = [&](int c) { return mesh.points[v[static_cast<std::size_t>(c)]]; };
    if (orient3d(at(k[0]), at(k[1]), at(k[2]), p) > 0) return false;
  }
  return true;
}

bool in_hull(const TetMesh& mesh, Vec3 p) {
  for (Tet t = 0; t < mesh.finite; ++t)
    if (holds(mesh, t, p)) return true;
  return false;
}

// Random points, or a grid: all walks then run along facets and edges.
TetMesh random_mesh(bool on_grid, test::Random& random) {
  std::vector<Vec3> points;
  for (int i = 0; i < 125; ++i) {
    if (on_grid)
      points.push_back({0.25 * (i % 5), 0.25 * (i / 5 % 5), 0.25 * (i / 25)});
    else
      points.push_back({random.unit(), random.unit(), random.unit()});
  }
  return test::delaunay_of(points);
}

RC_GTEST_PROP(Locate, AgreesWithBruteForce, (std::uint64_t seed, bool on_grid)) {
  test::Random random(seed);
  const TetMesh mesh = random_mesh(on_grid, random);
  for (int k = 0; k < 60; ++k) {
    Vec3 p = 1.4 * Vec3{random.unit(), random.unit(), random.unit()} - Vec3{0.2, 0.2, 0.2};
    const Vec3 a = mesh.points[random.below(125)], b = mesh.points[random.below(125)];
    if (k % 3 == 1) p = a;
    if (k % 3 == 2) p = 0.5 * (a + b);
    const Tet t = locate(mesh, p, static_cast<Tet>(random.below(mesh.size())));
    RC_ASSERT(t < mesh.size());
    RC_ASSERT((mesh.is_finite(t) ? holds(mesh, t, p) : !in_hull(mesh, p)));
  }
}

}  // namespace
}  // namespace arris
