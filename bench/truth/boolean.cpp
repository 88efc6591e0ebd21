#include "truth/boolean.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "arris/check.h"
#include "base/vec.h"
#include "truth/measure.h"

namespace arris::truth {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

ExactMesh to_exact(const Mesh& mesh) {
  ExactMesh exact;
  std::vector<ExactMesh::Vertex_index> vertex;
  for (const Vec3 p : mesh.vertices) vertex.push_back(exact.add_vertex({p.x, p.y, p.z}));
  for (const Triangle& t : mesh.triangles)
    if (exact.add_face(vertex.at(t[0]), vertex.at(t[1]), vertex.at(t[2])) == exact.null_face())
      throw std::invalid_argument("a solid is not manifold");
  return exact;
}

double rounded(const Kernel::FT& x) {
  return CGAL::to_double(CGAL::exact(x));  // of the lazy number it would be a coarse interval
}

Mesh to_doubles(const ExactMesh& exact) {
  Mesh mesh;
  std::vector<Index> index(exact.number_of_vertices() + exact.number_of_removed_vertices());
  for (const auto v : exact.vertices()) {
    index[v] = static_cast<Index>(mesh.vertices.size());
    const auto& p = exact.point(v);
    mesh.vertices.push_back({rounded(p.x()), rounded(p.y()), rounded(p.z())});
  }
  for (const auto f : exact.faces()) {
    Triangle t{};
    std::size_t i = 0;
    for (const auto v : exact.vertices_around_face(exact.halfedge(f))) t.at(i++) = index[v];
    mesh.triangles.push_back(t);
  }
  return mesh;
}

// Rounding turns the normal of a narrower triangle too far: a flat face would seem to have edges.
constexpr double narrowest_triangle = 1e-10;  // its least height, of the diagonal

// The least height of a triangle.
double narrowest(const Mesh& mesh) {
  double least = bounds_of(mesh.vertices).diagonal();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      longest = std::max(longest, distance(mesh.vertices[mesh.triangles[t][i]],
                                           mesh.vertices[mesh.triangles[t][(i + 1) % 3]]));
    least = std::min(least, length(normal(mesh, static_cast<Index>(t))) / longest);
  }
  return least;
}

bool compute(ExactMesh& a, ExactMesh& b, Operation operation, ExactMesh& result) {
  switch (operation) {
    case Operation::unite:
      return pmp::corefine_and_compute_union(a, b, result);
    case Operation::subtract:
      return pmp::corefine_and_compute_difference(a, b, result);
    case Operation::intersect:
      return pmp::corefine_and_compute_intersection(a, b, result);
  }
  return false;
}

}  // namespace

std::optional<Mesh> combine(const Mesh& a, const Mesh& b, Operation operation) {
  ExactMesh first = to_exact(a), second = to_exact(b), result;
  if (!compute(first, second, operation, result)) return std::nullopt;
  Mesh mesh = to_doubles(result);
  if (mesh.triangles.empty()) return mesh;
  if (narrowest(mesh) < narrowest_triangle * bounds_of(mesh.vertices).diagonal())
    return std::nullopt;
  const Result<Certificate> certificate = check(mesh);
  if (!certificate || !certificate->ok()) return std::nullopt;
  return mesh;
}

}  // namespace arris::truth
