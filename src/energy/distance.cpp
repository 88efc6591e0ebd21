#include "energy/distance.h"

#include <algorithm>
#include <limits>

#include "base/vec.h"

namespace arris {

FacetDistance facet_distance(const TetMesh& mesh, Tet t, int i) {
  const auto facet = static_cast<std::size_t>(i);
  const auto& corners = facet_corners[facet];
  std::array<Vec3, 3> x;
  for (std::size_t k = 0; k < 3; ++k)
    x[k] = mesh.points[mesh.vertices[t][static_cast<std::size_t>(corners[k])]];

  std::array<Vec3, 5> samples;
  std::size_t count = 0;
  const auto add = [&](Index v) {
    if (v != infinite_vertex) samples[count++] = mesh.points[mesh.nearest_sample(v)];
  };
  for (Index v : mesh.vertices[t]) add(v);
  const Tet n = mesh.neighbours[t][facet];
  add(mesh.vertices[n][static_cast<std::size_t>(mesh.facet_to(n, t))]);

  const auto d = [&](Vec3 p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < count; ++k)
      nearest = std::min(nearest, squared_length(p - samples[k]));
    return std::sqrt(nearest);
  };
  const double at_vertices = mesh.nearest.empty() ? 0 : d(x[0]) + d(x[1]) + d(x[2]);
  const double at_midpoints =
      d(0.5 * (x[0] + x[1])) + d(0.5 * (x[1] + x[2])) + d(0.5 * (x[2] + x[0]));
  const double at_centroid = d(1.0 / 3 * (x[0] + x[1] + x[2]));
  FacetDistance result;
  result.area = 0.5 * length(cross(x[1] - x[0], x[2] - x[0]));
  result.mean_distance = 1.0 / 20 * at_vertices + 2.0 / 15 * at_midpoints + 9.0 / 20 * at_centroid;
  return result;
}

}  // namespace arris
