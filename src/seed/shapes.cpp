#include "seed/shapes.h"

#include <algorithm>

#include "base/vec.h"
#include "seed/seeds.h"

namespace arris {
namespace {

constexpr double flat_height = 0.1;
// With less of a facet (squares of spacing) it costs nothing on either side: slivers along edges.
constexpr double bridge_area = 1;

}  // namespace

Vec3 centroid(const TetMesh& mesh, Tet t) {
  const auto& v = mesh.vertices[t];
  return 0.25 * (mesh.points[v[0]] + mesh.points[v[1]] + mesh.points[v[2]] + mesh.points[v[3]]);
}

double longest_edge(const TetMesh& mesh, Tet t) {
  double longest = 0;
  for (const auto& [i, j] : edge_corners)
    longest =
        std::max(longest, distance(mesh.points[mesh.vertices[t][static_cast<std::size_t>(i)]],
                                   mesh.points[mesh.vertices[t][static_cast<std::size_t>(j)]]));
  return longest;
}

bool is_bridge(const TetMesh& mesh, Tet t, const TetBase& base, double h) {
  return longest_edge(mesh, t) > 2 * firm_radius * h && base.twice_area > 2 * bridge_area * h * h &&
         base.height < flat_height * h;
}

Tet find_tet(const TetMesh& mesh, const Stars& stars, std::array<Index, 4> corners) {
  std::sort(corners.begin(), corners.end());
  if (corners[3] >= mesh.points.size()) return no_tet;
  for (Tet t : stars[corners[0]]) {
    std::array<Index, 4> other = mesh.vertices[t];
    std::sort(other.begin(), other.end());
    if (other == corners) return t;
  }
  return no_tet;
}

}  // namespace arris
