// Inside and outside of nested and scattered components.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "arris/check.h"
#include "shapes.h"

namespace arris {
namespace {

using namespace shapes;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;

Certificate certificate(const Mesh& mesh) {
  const auto result = check(mesh);
  EXPECT_TRUE(result) << result.error().message;
  return result ? *result : Certificate{};
}

SurfaceMesh oracle_mesh(const Mesh& mesh) {
  SurfaceMesh out;
  for (Vec3 p : mesh.vertices) out.add_vertex({p.x, p.y, p.z});
  using Vertex = SurfaceMesh::Vertex_index;
  for (const Triangle& t : mesh.triangles) out.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  return out;
}

TEST(CheckOrientation, ReversedSolid) {
  for (const Mesh& mesh : {tetrahedron(), cube(), torus(10)}) {
    const Certificate c = certificate(reversed(mesh));
    EXPECT_EQ(c.inward_components, 1u);
    EXPECT_FALSE(c.ok());
    EXPECT_LT(c.volume, 0);
    EXPECT_EQ(c.first_defect, "the component of triangle 0 has its normals pointing inwards");
  }
}

TEST(CheckOrientation, CavityFacesTheVoid) {
  const Mesh outer = cube({0, 0, 0}, 8), inner = cube({2, 2, 2}, 3);
  const Certificate right = certificate(joined(outer, reversed(inner)));
  EXPECT_TRUE(right.ok()) << right.first_defect;
  EXPECT_NEAR(right.volume, 512 - 27, 1e-10);
  const Certificate wrong = certificate(joined(outer, inner));
  EXPECT_EQ(wrong.inward_components, 1u);
  EXPECT_EQ(wrong.first_defect,
            "the component of triangle 12 bounds a cavity but its normals point out of it");
}

TEST(CheckOrientation, ShellsAlternate) {
  Mesh mesh;
  for (int depth = 0; depth < 6; ++depth) {
    const Mesh shell = cube({double(depth), double(depth), double(depth)}, 20 - 2 * depth);
    mesh = joined(mesh, depth % 2 == 0 ? shell : reversed(shell));
  }
  const Certificate c = certificate(mesh);
  EXPECT_TRUE(c.ok()) << c.first_defect;
  EXPECT_EQ(c.components, 6u);
  EXPECT_EQ(certificate(reversed(mesh)).inward_components, 6u);
}

// The hole of a torus is not inside it; a ball within its tube is.
TEST(CheckOrientation, TorusHoleIsOutside) {
  const Mesh ball = cube({-0.25, -0.25, -0.25}, 0.5);
  EXPECT_TRUE(certificate(joined(torus(40), ball)).ok());
  const Mesh in_tube = moved(ball, {2, 0, 0});
  EXPECT_TRUE(certificate(joined(torus(40), reversed(in_tube))).ok());
  EXPECT_EQ(certificate(joined(torus(40), in_tube)).inward_components, 1u);
}

// Rays along rows of aligned corners, edges and faces: every degenerate case at once.
TEST(CheckOrientation, ManyIslandsAlignedOnALattice) {
  Mesh mesh;
  for (int i = 0; i < 12 * 12 * 12; ++i) {
    const Vec3 lo{2.0 * (i % 12), 2.0 * (i / 12 % 12), 2.0 * (i / 144)};
    mesh = joined(std::move(mesh), cube(lo, 1 + 0.5 * (i % 2)));
  }
  const Certificate islands = certificate(mesh);
  EXPECT_TRUE(islands.ok()) << islands.first_defect;
  EXPECT_EQ(islands.components, 1728u);
  const Mesh shell = cube({-1, -1, -1}, 30);
  EXPECT_EQ(certificate(joined(mesh, shell)).inward_components, 1728u);
  EXPECT_TRUE(certificate(joined(reversed(mesh), shell)).ok());
}

// A stack of boxes, each in the one before and any of them reversed, and one box beside the stack.
RC_GTEST_PROP(CheckOrientation, AgreesWithAnOracleOnNestedBoxes, ()) {
  Mesh mesh;
  double lo = 0, size = 64;
  const auto flips = *rc::gen::container<std::vector<bool>>(rc::gen::arbitrary<bool>());
  std::uint64_t inward = 0;
  for (std::size_t i = 0; i < flips.size() && size > 2; ++i) {
    const Mesh box = cube({lo, lo, lo}, size);
    const Mesh tip = cube({lo + 100 + size, lo, lo}, size / 2);  // beside the stack, depth 0
    mesh = joined(mesh, flips[i] ? reversed(box) : box);
    if (i == 0) mesh = joined(mesh, flips[i] ? reversed(tip) : tip);
    inward += flips[i] != (i % 2 == 1);
    if (i == 0) inward += flips[i];
    const double gap = *rc::gen::element(0.25, 0.5, 1.0);
    lo += gap;
    size -= 2 * gap;
  }
  const Certificate c = certificate(mesh);
  RC_ASSERT(c.inward_components == inward);
  if (c.ok()) RC_ASSERT(PMP::does_bound_a_volume(oracle_mesh(mesh)));
}

// A random linear map of a torus, mirrored or not, with vertices on a coarse lattice so that ties
// in every coordinate are common.
RC_GTEST_PROP(CheckOrientation, AgreesWithCgalOnOneComponent, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  std::uniform_real_distribution<double> unit(-1, 1);
  const Vec3 x{unit(random), unit(random), unit(random)}, y{unit(random), unit(random), 0},
      z{unit(random), 0, unit(random)};
  Mesh mesh = *rc::gen::element(tetrahedron(), cube(), torus(8));
  const bool coarse = *rc::gen::arbitrary<bool>();
  for (Vec3& p : mesh.vertices) {
    p = p.x * x + p.y * y + p.z * z;
    if (coarse) p = {std::round(p.x * 4), std::round(p.y * 4), std::round(p.z * 4)};
  }
  const Certificate c = certificate(mesh);
  RC_PRE(c.degenerate_triangles == 0 && c.intersecting_pairs == 0);
  RC_ASSERT((c.inward_components == 0) == PMP::is_outward_oriented(oracle_mesh(mesh)));
  RC_ASSERT(c.ok() == (c.inward_components == 0));
}

}  // namespace
}  // namespace arris
