#include "swap/flat.h"

#include "base/parallel.h"
#include "tetra/geometry.h"

namespace arris {

std::vector<std::uint8_t> flat_tetrahedra(const TetMesh& mesh, const std::vector<double>& spacing,
                                          unsigned threads) {
  std::vector<std::uint8_t> flat(mesh.size(), 0);
  parallel_for(mesh.finite, threads, [&](std::size_t i) {
    const auto t = static_cast<Tet>(i);
    flat[i] = largest_base(mesh, t).height < sliver_height * mean_spacing(mesh, spacing, t);
  });
  return flat;
}

}  // namespace arris
