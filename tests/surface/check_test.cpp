// Each promise of the certificate, kept and broken.
#include "arris/check.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>

#include "shapes.h"

namespace arris {
namespace {

using namespace shapes;

Certificate certificate(const Mesh& mesh, unsigned threads = 1) {
  Context context;
  context.threads = threads;
  const auto result = check(mesh, context);
  EXPECT_TRUE(result) << result.error().message;
  return result ? *result : Certificate{};
}

// No defect but those whose counts the test names.
void expect_only(Certificate found, const Certificate& expected) {
  EXPECT_EQ(found.invalid_indices, expected.invalid_indices);
  EXPECT_EQ(found.non_finite_vertices, expected.non_finite_vertices);
  EXPECT_EQ(found.unreferenced_vertices, expected.unreferenced_vertices);
  EXPECT_EQ(found.degenerate_triangles, expected.degenerate_triangles);
  EXPECT_EQ(found.boundary_edges, expected.boundary_edges);
  EXPECT_EQ(found.nonmanifold_edges, expected.nonmanifold_edges);
  EXPECT_EQ(found.nonmanifold_vertices, expected.nonmanifold_vertices);
  EXPECT_EQ(found.misoriented_edges, expected.misoriented_edges);
  EXPECT_EQ(found.intersecting_pairs, expected.intersecting_pairs);
  EXPECT_EQ(found.inward_components, expected.inward_components);
  EXPECT_EQ(found.first_defect, expected.first_defect);
}

TEST(Check, Tetrahedron) {
  const Certificate c = certificate(tetrahedron());
  EXPECT_TRUE(c.ok());
  expect_only(c, {});
  EXPECT_EQ(c.vertices, 4u);
  EXPECT_EQ(c.edges, 6u);
  EXPECT_EQ(c.triangles, 4u);
  EXPECT_EQ(c.components, 1u);
  EXPECT_EQ(c.euler, 2);
  EXPECT_NEAR(c.volume, 1.0 / 6, 1e-15);
  EXPECT_NEAR(c.area, 1.5 + std::sqrt(3.0) / 2, 1e-15);
}

TEST(Check, Cube) {
  const Certificate c = certificate(cube());
  EXPECT_TRUE(c.ok());
  expect_only(c, {});
  EXPECT_EQ(c.edges, 18u);
  EXPECT_EQ(c.euler, 2);
  EXPECT_NEAR(c.volume, 1, 1e-15);
  EXPECT_NEAR(c.area, 6, 1e-14);
}

TEST(Check, Torus) {
  const Certificate c = certificate(torus(40));
  EXPECT_TRUE(c.ok());
  expect_only(c, {});
  EXPECT_EQ(c.euler, 0);
  EXPECT_EQ(c.edges, 3u * 1600);
  EXPECT_NEAR(c.volume, 4 * std::pow(std::numbers::pi, 2), 0.5);
}

TEST(Check, EmptyMeshIsNotCertified) {
  const Certificate c = certificate({});
  EXPECT_FALSE(c.ok());
  expect_only(c, {.first_defect = "the mesh has no triangles"});
}

TEST(Check, InvalidIndexSkipsGeometry) {
  Mesh mesh = cube();
  mesh.triangles.push_back({1, 8, 99});
  const Certificate c = certificate(mesh);
  EXPECT_FALSE(c.ok());
  expect_only(c,
              {.invalid_indices = 2,
               .first_defect = "triangle 12 names vertex 8 of 8; its geometry was not examined"});
  EXPECT_EQ(c.area, 0);
}

TEST(Check, NonFiniteVerticesSkipGeometry) {
  Mesh mesh = cube();
  mesh.vertices[3].y = std::numeric_limits<double>::quiet_NaN();
  mesh.vertices[5].z = -std::numeric_limits<double>::infinity();
  const Certificate c = certificate(mesh);
  EXPECT_FALSE(c.ok());
  expect_only(c, {.non_finite_vertices = 2,
                  .first_defect = "vertex 3 is not finite; its geometry was not examined"});
}

TEST(Check, UnreferencedVertexIsNoDefect) {
  Mesh mesh = cube();
  mesh.vertices.push_back({0.5, 0.5, 0});
  const Certificate c = certificate(mesh);
  EXPECT_TRUE(c.ok());
  expect_only(c, {.unreferenced_vertices = 1, .first_defect = ""});
  EXPECT_EQ(c.euler, 2);
}

TEST(Check, RepeatedCorner) {
  Mesh mesh = cube();
  mesh.triangles.push_back({4, 7, 4});
  const Certificate c = certificate(mesh);
  EXPECT_FALSE(c.ok());
  expect_only(c,
              {.degenerate_triangles = 1, .first_defect = "triangle 12 has the same corner twice"});
}

// Vertex 8 lies on the edge 0-3 of the bottom and makes a flat triangle beside each neighbour.
TEST(Check, CollinearCorners) {
  Mesh mesh = cube();
  mesh.vertices.push_back({0.25, 0.25, 0});
  mesh.triangles[1] = {8, 3, 1};
  mesh.triangles.push_back({0, 8, 1});
  mesh.triangles.push_back({0, 3, 8});
  const Certificate c = certificate(mesh);
  EXPECT_FALSE(c.ok());
  EXPECT_EQ(c.degenerate_triangles, 1u);
  EXPECT_EQ(c.boundary_edges, 0u);
  EXPECT_EQ(c.euler, 2);
  EXPECT_EQ(c.first_defect, "the corners of triangle 13 lie on one line");
}

TEST(Check, MissingTriangleLeavesABoundary) {
  Mesh mesh = cube();
  mesh.triangles.pop_back();
  const Certificate c = certificate(mesh);
  EXPECT_FALSE(c.closed());
  EXPECT_TRUE(c.manifold());
  expect_only(c, {.boundary_edges = 3, .first_defect = "edge 1-5 has only one triangle"});
  EXPECT_EQ(c.euler, 1);
}

// Two cubes along a common edge: four triangles round it.
TEST(Check, NonmanifoldEdge) {
  Mesh mesh = joined(cube(), cube({1, 1, 0}));
  for (Triangle& t : mesh.triangles)
    for (Index& v : t) v = v == 8 ? 3 : v == 12 ? 7 : v;
  const Certificate c = certificate(mesh);
  EXPECT_TRUE(c.closed());
  EXPECT_FALSE(c.ok());
  expect_only(c, {.unreferenced_vertices = 2,
                  .nonmanifold_edges = 1,
                  .nonmanifold_vertices = 2,
                  .first_defect = "edge 3-7 has 4 triangles"});
  EXPECT_EQ(c.components, 1u);
  EXPECT_NEAR(c.volume, 2, 1e-14);
}

TEST(Check, NonmanifoldVertex) {
  Mesh mesh = joined(cube(), cube({1, 1, 1}));
  for (Triangle& t : mesh.triangles)
    for (Index& v : t) v = v == 8 ? 7 : v;
  const Certificate c = certificate(mesh);
  EXPECT_FALSE(c.manifold());
  expect_only(c, {.unreferenced_vertices = 1,
                  .nonmanifold_vertices = 1,
                  .first_defect = "the triangles round vertex 7 form 2 fans"});
  EXPECT_EQ(c.components, 2u);
}

// The same place, but no common index: manifold, and touching.
TEST(Check, TouchingComponentsIntersect) {
  const Mesh mesh = joined(cube(), tetrahedron());
  Mesh touching = joined(cube(), moved(tetrahedron(), {1, 1, 1}));
  const Certificate c = certificate(touching);
  EXPECT_TRUE(c.manifold());
  EXPECT_FALSE(c.ok());
  EXPECT_EQ(c.intersecting_pairs, 6u * 3u);  // triangles round vertex 7 by triangles round vertex 8
  EXPECT_EQ(c.first_defect, "triangles 2 and 12 intersect");
  EXPECT_GT(certificate(mesh).intersecting_pairs, 18u);
}

TEST(Check, MisorientedTriangle) {
  Mesh mesh = cube();
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  const Certificate c = certificate(mesh);
  EXPECT_FALSE(c.oriented());
  expect_only(c, {.misoriented_edges = 3,
                  .first_defect = "both triangles at edge 0-1 walk it in the same direction"});
}

// Vertex 6 of the cube pushed through the opposite corner.
TEST(Check, SelfIntersection) {
  Mesh mesh = cube();
  mesh.vertices[6] = {2, -1, 0.5};
  const Certificate c = certificate(mesh);
  EXPECT_FALSE(c.ok());
  EXPECT_GT(c.intersecting_pairs, 0u);
  EXPECT_NE(c.first_defect.find("intersect"), std::string::npos);
}

// Two copies of a triangle, back to back: closed and manifold, but no solid.
TEST(Check, PillowIntersects) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
  const Certificate c = certificate(mesh);
  EXPECT_FALSE(c.ok());
  expect_only(c, {.intersecting_pairs = 1, .first_defect = "triangles 0 and 1 intersect"});
  EXPECT_EQ(c.euler, 2);
}

TEST(Check, FoldedGridIntersects) {
  Mesh mesh = grid(2);
  EXPECT_EQ(certificate(mesh).intersecting_pairs, 0u);
  for (Vec3& p : mesh.vertices)
    if (p.x == 2) p.x = 0.5;  // the second column folds back over the first
  EXPECT_GT(certificate(mesh).intersecting_pairs, 0u);
}

TEST(Check, AllScalesAndFarFromZero) {
  for (const double scale : {1e150, 1e-150, 0x1p-1000, 0x1p1000}) {
    const Certificate c = certificate(scaled(torus(12), scale));
    EXPECT_TRUE(c.ok()) << scale << ": " << c.first_defect;
    EXPECT_GT(c.volume, 0);
    EXPECT_TRUE(std::isfinite(c.volume));
    EXPECT_TRUE(std::isfinite(c.area));
    EXPECT_EQ(certificate(reversed(scaled(torus(12), scale))).inward_components, 1u);
  }
  const Certificate utm = certificate(moved(scaled(torus(30), 0.5), {5e5, 1e7, 120}));
  EXPECT_TRUE(utm.ok()) << utm.first_defect;
  EXPECT_NEAR(utm.volume, certificate(torus(30)).volume / 8, 1e-6);
}

// A sliver whose volume drowns in rounding: the sign is exact all the same.
TEST(Check, ThinSolidHasTheRightSign) {
  Mesh mesh;
  mesh.vertices = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1.0 / 3, 1.0 / 3, 1.0 / 3}};
  mesh.triangles = tetrahedron().triangles;
  const Certificate a = certificate(mesh), b = certificate(reversed(mesh));
  ASSERT_EQ(a.degenerate_triangles, 0u);
  EXPECT_NE(a.ok(), b.ok());
  EXPECT_EQ(a.inward_components + b.inward_components, 1u);
}

TEST(Check, ThreadsDoNotMatter) {
  Mesh mesh = joined(torus(60), moved(torus(50), {1.5, 0, 0.1}));
  mesh.triangles[100] = {7, 7, 9};
  mesh.triangles.erase(mesh.triangles.begin() + 4000);
  const Certificate one = certificate(mesh, 1);
  EXPECT_GT(one.intersecting_pairs, 0u);
  for (const unsigned threads : {2u, 5u}) {
    const Certificate many = certificate(mesh, threads);
    expect_only(many, one);
    EXPECT_EQ(many.volume, one.volume);
    EXPECT_EQ(many.area, one.area);
    EXPECT_EQ(many.components, one.components);
    EXPECT_EQ(many.euler, one.euler);
  }
}

TEST(Check, StopsOnRequestAndTellsProgress) {
  const Mesh mesh = torus(200);
  std::atomic<bool> stop{true};
  Context context;
  context.cancel = &stop;
  const auto stopped = check(mesh, context);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
  stop = false;
  double last = -1;
  context.progress = [&](std::string_view stage, double fraction) {
    EXPECT_EQ(stage, "check");
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  EXPECT_TRUE(check(mesh, context));
  EXPECT_EQ(last, 1);
}

TEST(Check, RefusesMoreThanTheMemoryLimit) {
  Context context;
  context.memory_limit = 1000;
  const auto refused = check(torus(50), context);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::out_of_memory);
}

}  // namespace
}  // namespace arris
