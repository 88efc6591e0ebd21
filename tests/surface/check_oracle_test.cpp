// Counts of intersecting pairs against CGAL.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "arris/check.h"
#include "shapes.h"
#include "tetra/predicates.h"

namespace arris {
namespace {

using namespace shapes;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;

// A surface mesh of as many of the triangles as can be put together; the others leave `mesh`, as do
// degenerate ones, and those that share two corners without being neighbours, of which the oracle
// has another opinion.
SurfaceMesh oracle_mesh(Mesh& mesh) {
  SurfaceMesh out;
  for (Vec3 p : mesh.vertices) out.add_vertex({p.x, p.y, p.z});
  std::vector<Triangle> kept;
  for (const Triangle& t : mesh.triangles) {
    if (collinear(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]])) continue;
    bool same_direction = false;
    for (const Triangle& k : kept)
      for (std::size_t i = 0; i < 9; ++i)
        same_direction |= t[i % 3] == k[i / 3] && t[(i % 3 + 1) % 3] == k[(i / 3 + 1) % 3];
    using Vertex = SurfaceMesh::Vertex_index;
    if (!same_direction &&
        out.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) != SurfaceMesh::null_face())
      kept.push_back(t);
  }
  mesh.triangles = kept;
  return out;
}

std::size_t oracle_pairs(const SurfaceMesh& mesh) {
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
  PMP::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}

void agree(Mesh mesh, bool expect_some = false) {
  const SurfaceMesh oracle = oracle_mesh(mesh);
  const auto c = check(mesh);
  RC_ASSERT(bool(c));
  RC_ASSERT(c->degenerate_triangles == 0u);
  RC_ASSERT(c->intersecting_pairs == oracle_pairs(oracle));
  if (expect_some) RC_ASSERT(c->intersecting_pairs > 0u);
  RC_TAG(c->intersecting_pairs > 0 ? "some" : "none");
}

// Coordinates from a small lattice: coplanar, collinear and coinciding corners all the time.
Vec3 lattice_point(int size) {
  return {double(*rc::gen::inRange(0, size)), double(*rc::gen::inRange(0, size)),
          double(*rc::gen::inRange(0, size))};
}

RC_GTEST_PROP(CheckAgainstCgal, SeparateTrianglesOnALattice, ()) {
  Mesh mesh;
  const int size = *rc::gen::inRange(2, 6), n = *rc::gen::inRange(2, 25);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(lattice_point(size));
    const auto v = static_cast<Index>(3 * i);
    mesh.triangles.push_back({v, v + 1, v + 2});
  }
  agree(mesh);
}

RC_GTEST_PROP(CheckAgainstCgal, IndexedTrianglesOnALattice, ()) {
  Mesh mesh;
  const int size = *rc::gen::inRange(2, 6), n = *rc::gen::inRange(2, 40);
  const Index vertices = *rc::gen::inRange<Index>(4, 20);
  for (Index v = 0; v < vertices; ++v) mesh.vertices.push_back(lattice_point(size));
  for (int i = 0; i < n; ++i) {
    Triangle t;
    for (Index& v : t) v = *rc::gen::inRange<Index>(0, vertices);
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
  }
  agree(mesh);
}

RC_GTEST_PROP(CheckAgainstCgal, CoplanarTriangles, ()) {
  Mesh mesh;
  const Vec3 u = lattice_point(4), v = lattice_point(4);
  for (Index i = 0; i < 12; ++i)
    mesh.vertices.push_back(double(*rc::gen::inRange(0, 5)) * u +
                            double(*rc::gen::inRange(0, 5)) * v);
  const int n = *rc::gen::inRange(2, 15);
  for (int i = 0; i < n; ++i) {
    Triangle t;
    for (Index& w : t) w = *rc::gen::inRange<Index>(0, 12);
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
  }
  agree(mesh);
}

RC_GTEST_PROP(CheckAgainstCgal, PerturbedTorus, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const double amplitude = *rc::gen::element(0.0, 0.05, 0.2, 0.5, 2.0);
  std::uniform_real_distribution<double> noise(-amplitude, amplitude);
  const Vec3 shift = *rc::gen::element(Vec3{}, Vec3{5e5, 1e7, 30}, Vec3{-1e3, 0, 1e-3});
  Mesh mesh = torus(14);
  for (Vec3& p : mesh.vertices) p = p + shift + Vec3{noise(random), noise(random), noise(random)};
  agree(mesh, amplitude >= 2);
}

// Neighbours folded on each other, and corners on the sides of others.
RC_GTEST_PROP(CheckAgainstCgal, GridSquashedOntoALattice, ()) {
  Mesh mesh = grid(6);
  const int size = *rc::gen::inRange(2, 7);
  for (Vec3& p : mesh.vertices)
    if (*rc::gen::inRange(0, 4) == 0) p = lattice_point(size);
  agree(mesh);
}

RC_GTEST_PROP(CheckAgainstCgal, NearlyCoplanarAtAnyScale, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  std::uniform_real_distribution<double> unit(0, 1);
  const double scale = *rc::gen::element(1.0, 1e150, 1e-150);
  const Vec3 u{unit(random), unit(random), unit(random)}, v{unit(random), -unit(random), 0.5};
  Mesh mesh;
  for (Index i = 0; i < 60; ++i) {
    mesh.vertices.push_back(scale * (unit(random) * u + unit(random) * v));
    if (i % 3 == 2) mesh.triangles.push_back({i - 2, i - 1, i});
  }
  agree(mesh, true);
}

}  // namespace
}  // namespace arris
