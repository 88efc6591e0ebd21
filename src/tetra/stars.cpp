#include "tetra/stars.h"

#include <numeric>

namespace arris {

Stars::Stars(const TetMesh& mesh) : start_(mesh.points.size() + 1, 0) {
  for (const auto& corners : mesh.vertices)
    for (Index v : corners)
      if (v != infinite_vertex) ++start_[v + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  tets_.resize(start_.back());
  std::vector<std::uint64_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t t = 0; t < mesh.size(); ++t)
    for (Index v : mesh.vertices[t])
      if (v != infinite_vertex) tets_[next[v]++] = static_cast<Tet>(t);
}

}  // namespace arris
