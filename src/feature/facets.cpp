#include "feature/facets.h"

#include "base/failure.h"

namespace arris {
namespace {

// The facets at each point, in the order of the facets.
void fill_stars(FacetMesh& mesh, std::size_t points) {
  mesh.first.assign(points + 1, 0);
  for (const Triangle& t : mesh.facets)
    for (Index v : t) ++mesh.first[v + 1];
  for (std::size_t v = 0; v < points; ++v) mesh.first[v + 1] += mesh.first[v];
  mesh.around.resize(mesh.facets.size() * 3);
  std::vector<Index> next(mesh.first.begin(), mesh.first.end() - 1);
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
    for (Index v : mesh.facets[f]) mesh.around[next[v]++] = static_cast<Index>(f);
}

// The facet that has the directed side b -> a.
Index facet_with_side(const FacetMesh& mesh, Index b, Index a) {
  for (Index f : mesh.star(b))
    for (std::size_t i = 0; i < 3; ++i)
      if (mesh.facets[f][i] == b && mesh.facets[f][(i + 1) % 3] == a) return f;
  return no_index;
}

}  // namespace

FacetMesh::FacetMesh(std::vector<Triangle> triangles, std::size_t points)
    : facets(std::move(triangles)) {
  fill_stars(*this, points);
  neighbours.resize(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      neighbours[f][i] = facet_with_side(*this, facets[f][(i + 2) % 3], facets[f][(i + 1) % 3]);
      if (neighbours[f][i] == no_index)
        throw Failure(ErrorCode::internal, "a surface to sense features on is not closed",
                      "please report it with the input");
    }
}

int corner_opposite(const FacetMesh& mesh, Index f, Index other) noexcept {
  const auto& n = mesh.neighbours[f];
  return n[0] == other ? 0 : n[1] == other ? 1 : 2;
}

}  // namespace arris
