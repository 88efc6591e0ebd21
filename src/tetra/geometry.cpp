#include "tetra/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "base/vec.h"

namespace arris {
namespace {

// A point inside a well-sampled surface has about six neighbours on it, of which the fourth
// nearest is at the typical distance for regular, blue-noise and random sampling alike.
constexpr std::size_t spacing_rank = 4;

struct Edge {
  double squared_length;
  Index end;
  friend bool operator<(const Edge& a, const Edge& b) {
    return a.squared_length != b.squared_length ? a.squared_length < b.squared_length
                                                : a.end < b.end;
  }
  friend bool operator==(const Edge& a, const Edge& b) { return a.end == b.end; }
};

// The shortest Delaunay edges at v, at most spacing_rank, ascending.
std::size_t shortest_edges(const TetMesh& mesh, const Stars& stars, Index v,
                           std::array<Edge, spacing_rank>& shortest) {
  std::size_t count = 0;
  for (Tet t : stars[v]) {
    for (Index w : mesh.vertices[t]) {
      if (w == v || w == infinite_vertex) continue;
      const Edge edge{squared_length(mesh.points[w] - mesh.points[v]), w};
      const auto end = shortest.begin() + static_cast<std::ptrdiff_t>(count);
      const auto at = std::lower_bound(shortest.begin(), end, edge);
      if (at == shortest.end() || (at != end && *at == edge)) continue;
      if (count < spacing_rank) ++count;
      std::move_backward(at, shortest.begin() + static_cast<std::ptrdiff_t>(count) - 1,
                         shortest.begin() + static_cast<std::ptrdiff_t>(count));
      *at = edge;
    }
  }
  return count;
}

}  // namespace

Circumball circumball(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double twice_det = 2 * dot(u, cross(v, w));
  const Vec3 from_a = 1 / twice_det *
                      (squared_length(u) * cross(v, w) + squared_length(v) * cross(w, u) +
                       squared_length(w) * cross(u, v));
  if (!is_finite(from_a)) return {a, std::numeric_limits<double>::infinity()};
  return {a + from_a, length(from_a)};
}

std::vector<Circumball> circumballs(const TetMesh& mesh, unsigned threads) {
  std::vector<Circumball> balls(mesh.finite);
  parallel_for(mesh.finite, threads, [&](std::size_t t) {
    const auto& v = mesh.vertices[t];
    balls[t] =
        circumball(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
  });
  return balls;
}

std::vector<double> sample_spacing(const TetMesh& mesh, const Stars& stars, unsigned threads) {
  std::vector<double> raw(mesh.points.size()), spacing(mesh.points.size());
  std::vector<std::array<Edge, spacing_rank>> edges(mesh.points.size());
  std::vector<std::uint8_t> counts(mesh.points.size());
  parallel_for(raw.size(), threads, [&](std::size_t v) {
    const std::size_t count = shortest_edges(mesh, stars, static_cast<Index>(v), edges[v]);
    counts[v] = static_cast<std::uint8_t>(count);
    raw[v] = std::sqrt(edges[v][count - 1].squared_length);
  });
  parallel_for(raw.size(), threads, [&](std::size_t v) {
    std::array<double, spacing_rank + 1> around;
    around[0] = raw[v];
    for (std::size_t k = 0; k < counts[v]; ++k) around[k + 1] = raw[edges[v][k].end];
    const auto middle = around.begin() + counts[v] / 2;
    std::nth_element(around.begin(), middle, around.begin() + counts[v] + 1);
    spacing[v] = *middle;
  });
  return spacing;
}

}  // namespace arris
