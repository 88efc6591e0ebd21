#include "tetra/tet_mesh.h"

namespace arris {

std::vector<Tet> star_seeds(const TetMesh& mesh) {
  std::vector<Tet> seeds(mesh.points.size(), no_tet);
  for (std::size_t t = mesh.size(); t-- > 0;)  // downwards, so that finite ones win
    for (Index v : mesh.vertices[t])
      if (v != infinite_vertex) seeds[v] = static_cast<Tet>(t);
  return seeds;
}

}  // namespace arris
