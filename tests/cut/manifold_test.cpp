#include "cut/manifold.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vec.h"
#include "support/known_solids.h"
#include "support/random.h"
#include "support/tetra.h"
#include "swap/topology.h"

namespace arris {
namespace {

using namespace test;

// Random points, or a grid with many flat and equal tetrahedra.
TetMesh random_mesh(bool on_grid, std::size_t n, Random& random) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(on_grid ? Vec3{static_cast<double>(i % 4), static_cast<double>(i / 4 % 4),
                                    static_cast<double>(i / 16)}
                             : Vec3{random.unit(), random.unit(), random.unit()});
  return delaunay_of(points);
}

Labels random_labels(const TetMesh& mesh, double share, Random& random) {
  Labels labels(mesh.size(), 0);
  for (Tet t = 0; t < mesh.finite; ++t) labels[t] = random.unit() < share;
  return labels;
}

// The area of the facet.
double area(const TetMesh& mesh, Tet t, int i) {
  const auto at = [&](int k) {
    const int corner = facet_corners[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
    return mesh.points[mesh.vertices[t][static_cast<std::size_t>(corner)]];
  };
  if (!mesh.is_finite(t) && !mesh.is_finite(mesh.neighbours[t][static_cast<std::size_t>(i)]))
    return 0;
  return 0.5 * length(cross(at(1) - at(0), at(2) - at(0)));
}

std::uint64_t untangle(const TetMesh& mesh, Labels& labels) {
  OneStageJob job;
  return make_manifold(
      mesh, Stars(mesh), [&](Tet t, int i) { return area(mesh, t, i); }, labels, job);
}

RC_GTEST_PROP(MakeManifold, AlwaysEndsWithAManifold, (std::uint64_t seed, bool on_grid)) {
  Random random(seed);
  const auto n = *rc::gen::inRange<std::size_t>(20, 200);
  const double share = *rc::gen::element(0.05, 0.3, 0.5, 0.7, 0.95, 1.0);
  const TetMesh mesh = random_mesh(on_grid, n, random);
  Labels labels = random_labels(mesh, share, random);
  const Labels before = labels;
  const bool was_manifold = topology(mesh, labels).manifold;
  const std::uint64_t flips = untangle(mesh, labels);
  RC_ASSERT(topology(mesh, labels).manifold);
  RC_ASSERT((flips == 0) == was_manifold);
  if (was_manifold) {
    RC_ASSERT(labels == before);
  }
  for (std::size_t t = mesh.finite; t < mesh.size(); ++t) RC_ASSERT(labels[t] == 0);
  RC_ASSERT(untangle(mesh, labels) == 0u);
}

RC_GTEST_PROP(RegularVertex, AgreesWithTheLinksOfTheBoundary, (std::uint64_t seed, bool on_grid)) {
  Random random(seed);
  const auto n = *rc::gen::inRange<std::size_t>(20, 60);
  const TetMesh mesh = random_mesh(on_grid, n, random);
  Labels labels = random_labels(mesh, *rc::gen::element(0.02, 0.1, 0.9, 0.98), random);
  const Stars stars(mesh);
  bool regular = true;
  for (Index v = 0; v < n; ++v) regular &= is_regular_vertex(mesh, labels, stars[v], v);
  RC_ASSERT(regular == topology(mesh, labels).manifold);
}

TEST(MakeManifold, LeavesASolidAlone) {
  const KnownSolid cube = known_solids(500)[1];
  const TetMesh mesh = delaunay_of(cube.samples);
  Labels labels(mesh.size(), 0);
  std::fill_n(labels.begin(), mesh.finite, std::uint8_t{1});  // the convex hull
  const Labels before = labels;
  EXPECT_EQ(untangle(mesh, labels), 0u);
  EXPECT_EQ(labels, before);
}

TEST(MakeManifold, FlipsOneTetrahedronToCloseAPinch) {
  const KnownSolid cube = known_solids(500)[1];
  const TetMesh mesh = delaunay_of(cube.samples);
  // Carves from the hull one tetrahedron that touches it in a corner alone.
  Labels labels(mesh.size(), 0);
  std::fill_n(labels.begin(), mesh.finite, std::uint8_t{1});
  for (Tet t = 0; t < mesh.finite; ++t) {
    const auto& n = mesh.neighbours[t];
    if (!std::all_of(n.begin(), n.end(), [&](Tet s) { return mesh.is_finite(s); })) continue;
    labels[t] = 0;
    break;
  }
  ASSERT_FALSE(topology(mesh, labels).manifold);
  EXPECT_EQ(untangle(mesh, labels), 1u);
  EXPECT_TRUE(topology(mesh, labels).manifold);
}

// n tetrahedra like the slices of a cake: the link of each end of the axis has up to n + 2 edges.
TEST(Manifold, EndsOfAnEdgeWithVeryManyTetrahedraAreJudgedAsOthers) {
  constexpr Index n = 200;
  std::vector<Vec3> points = {{0, 0, 0.3}, {0, 0, -0.3}};
  for (Index k = 0; k < n; ++k) {
    const double a = 2 * std::numbers::pi * k / n;
    points.push_back({std::cos(a), std::sin(a), 0});
  }
  const TetMesh mesh = delaunay_of(points);
  const Stars stars(mesh);
  const auto regular_ends = [&](auto&& is_inside) {
    Labels labels(mesh.size(), 0);
    for (Tet t = 0; t < mesh.finite; ++t) {
      const Vec3 c = centroid_of(mesh, t);
      labels[t] = is_inside(std::atan2(c.y, c.x));
    }
    int regular = 0;
    for (Index v = 0; v < n + 2; ++v)
      if (squared_length(mesh.points[v] - Vec3{0, 0, mesh.points[v].z}) < 0.5)
        regular += is_regular_vertex(mesh, labels, stars[v], v);
    return regular;
  };
  EXPECT_EQ(regular_ends([](double) { return true; }), 2);
  EXPECT_EQ(regular_ends([](double a) { return a > 0.1; }), 2);
  EXPECT_EQ(regular_ends([](double a) { return std::abs(a) > 0.5 && std::abs(a) < 2; }), 0);
}

}  // namespace
}  // namespace arris
