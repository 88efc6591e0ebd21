#include "swap/flat.h"

#include <algorithm>

#include "base/parallel.h"
#include "base/vec.h"
#include "tetra/geometry.h"

namespace arris {
namespace {

// In spacings: far below what a surface shows, far above the rounding of float coordinates (about
// 1e-5 spacings). Without it, swaps on the sampled edges of a dodecahedron, which were exact after
// the cut, took the strict edge F1 from 1.00 to 0.98.
constexpr double flat_height = 1e-3;

double least_height(const TetMesh& mesh, Tet t) {
  std::array<Vec3, 4> x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = mesh.points[mesh.vertices[t][i]];
  const double volume6 = dot(cross(x[1] - x[0], x[2] - x[0]), x[3] - x[0]);
  double largest = 0;
  for (const auto& k : facet_corners) {
    const Vec3 a = x[static_cast<std::size_t>(k[0])];
    largest = std::max(largest, squared_length(cross(x[static_cast<std::size_t>(k[1])] - a,
                                                     x[static_cast<std::size_t>(k[2])] - a)));
  }
  return largest > 0 ? volume6 / std::sqrt(largest) : 0;
}

}  // namespace

std::vector<std::uint8_t> flat_tetrahedra(const TetMesh& mesh, const std::vector<double>& spacing,
                                          unsigned threads) {
  std::vector<std::uint8_t> flat(mesh.size(), 0);
  parallel_for(mesh.finite, threads, [&](std::size_t i) {
    const auto t = static_cast<Tet>(i);
    flat[i] = least_height(mesh, t) < flat_height * mean_spacing(mesh, spacing, t);
  });
  return flat;
}

}  // namespace arris
