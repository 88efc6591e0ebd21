#include "tetra/tet_mesh.h"

#include <algorithm>

namespace arris {

std::vector<Tet> star_seeds(const TetMesh& mesh) {
  std::vector<Tet> seeds(mesh.points.size(), no_tet);
  for (std::size_t t = mesh.size(); t-- > 0;)  // downwards, so that finite ones win
    for (Index v : mesh.vertices[t])
      if (v != infinite_vertex) seeds[v] = static_cast<Tet>(t);
  return seeds;
}

void collect_star(const TetMesh& mesh, Index v, Tet seed, std::vector<Tet>& star) {
  const std::size_t first = star.size();
  star.push_back(seed);
  for (std::size_t k = first; k < star.size(); ++k) {
    const Tet t = star[k];
    for (int i = 0; i < 4; ++i) {
      if (mesh.vertices[t][static_cast<std::size_t>(i)] == v) continue;
      const Tet n = mesh.neighbours[t][static_cast<std::size_t>(i)];
      if (std::find(star.begin() + static_cast<std::ptrdiff_t>(first), star.end(), n) == star.end())
        star.push_back(n);
    }
  }
}

}  // namespace arris
