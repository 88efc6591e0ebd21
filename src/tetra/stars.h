// Which tetrahedra meet at each vertex, in one flat array.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tetra/tet_mesh.h"

namespace arris {

// Stars in compressed rows: those of vertex v, infinite tetrahedra included, in increasing order.
// About 27 entries a vertex near a surface; 4 bytes each.
class Stars {
 public:
  Stars() = default;
  explicit Stars(const TetMesh& mesh);
  std::span<const Tet> operator[](Index v) const noexcept {
    return {tets_.data() + start_[v], tets_.data() + start_[v + 1]};
  }

 private:
  std::vector<std::uint64_t> start_;
  std::vector<Tet> tets_;
};

}  // namespace arris
