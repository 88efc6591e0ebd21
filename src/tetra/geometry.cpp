#include "tetra/geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "base/vec.h"
#include "tetra/double_double.h"

namespace arris {
namespace {

// A point inside a well-sampled surface has about six neighbours on it, of which the fourth
// nearest is at the typical distance for regular, blue-noise and random sampling alike.
constexpr std::size_t spacing_rank = 4;

// In the local frame, whose extent is about 1. Costs are divided by the cube of the spacing, which
// must neither underflow nor make them overflow.
constexpr double smallest_spacing = 0x1p-200;

struct Edge {
  double squared_length;
  Index end;
  friend bool operator<(const Edge& a, const Edge& b) {
    return a.squared_length != b.squared_length ? a.squared_length < b.squared_length
                                                : a.end < b.end;
  }
  friend bool operator==(const Edge& a, const Edge& b) { return a.end == b.end; }
};

// The shortest edges met so far, at most spacing_rank, ascending and distinct.
struct Shortest {
  std::array<Edge, spacing_rank> edges;
  std::size_t count = 0;

  void offer(const Edge& edge) {
    if (count == spacing_rank && edge.squared_length > edges.back().squared_length) return;
    const auto end = edges.begin() + static_cast<std::ptrdiff_t>(count);
    const auto at = std::lower_bound(edges.begin(), end, edge);
    if (at == edges.end() || (at != end && *at == edge)) return;
    if (count < spacing_rank) ++count;
    const auto last = edges.begin() + static_cast<std::ptrdiff_t>(count);
    std::move_backward(at, last - 1, last);
    *at = edge;
  }
};

// The shortest Delaunay edges at v.
Shortest shortest_edges(const TetMesh& mesh, const Stars& stars, Index v) {
  // Each neighbour is met in five or six tetrahedra; remembering the last one per slot spares most
  // of the repeats. Those that slip through are caught when they are offered. Without a branch,
  // which nothing could predict.
  constexpr std::size_t tets_at_once = 32;
  std::array<Index, 64> met;
  met.fill(v);
  std::array<Index, 4 * tets_at_once + 1> ends;
  Shortest shortest;
  const auto star = stars[v];
  for (std::size_t from = 0; from < star.size(); from += tets_at_once) {
    std::size_t count = 0;
    for (Tet t : star.subspan(from, std::min(tets_at_once, star.size() - from)))
      for (Index w : mesh.vertices[t]) {
        Index& slot = met[w % met.size()];
        ends[count] = w;
        count += static_cast<std::size_t>(w != slot) & static_cast<std::size_t>(w != v) &
                 static_cast<std::size_t>(w != infinite_vertex);
        slot = w;
      }
    for (std::size_t k = 0; k < count; ++k)
      shortest.offer({squared_length(mesh.points[ends[k]] - mesh.points[v]), ends[k]});
  }
  return shortest;
}

// The circumcentre seen from a corner is `numerator` / (2 `det`).
struct Centre {
  Vec3 numerator;
  double det = 0;
};

Centre plain_centre(Vec3 u, Vec3 v, Vec3 w) {
  return {squared_length(u) * cross(v, w) + squared_length(v) * cross(w, u) +
              squared_length(w) * cross(u, v),
          dot(u, cross(v, w))};
}

struct LongVec3 {
  DoubleDouble x, y, z;
};
LongVec3 difference(Vec3 a, Vec3 b) {
  return {DoubleDouble::sum(a.x, -b.x), DoubleDouble::sum(a.y, -b.y), DoubleDouble::sum(a.z, -b.z)};
}
LongVec3 long_cross(const LongVec3& a, const LongVec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
DoubleDouble long_dot(const LongVec3& a, const LongVec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Centre long_centre(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const LongVec3 u = difference(b, a), v = difference(c, a), w = difference(d, a);
  const LongVec3 vw = long_cross(v, w), wu = long_cross(w, u), uv = long_cross(u, v);
  const DoubleDouble uu = long_dot(u, u), vv = long_dot(v, v), ww = long_dot(w, w);
  return {{(uu * vw.x + vv * wu.x + ww * uv.x).hi, (uu * vw.y + vv * wu.y + ww * uv.y).hi,
           (uu * vw.z + vv * wu.z + ww * uv.z).hi},
          long_dot(u, vw).hi};
}

// Below this share of the product of the three edge lengths, the volume of a tetrahedron computed
// in doubles has lost more than half of its bits, and with it the circumcentre.
constexpr double flat_for_double = 0x1p-26;
// The same for double-double numbers.
constexpr double flat_for_double_double = 0x1p-78;

}  // namespace

Circumball circumball(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double box = length(u) * length(v) * length(w);
  Centre centre = plain_centre(u, v, w);
  if (!(std::abs(centre.det) > flat_for_double * box)) {
    centre = long_centre(a, b, c, d);
    if (!(std::abs(centre.det) > flat_for_double_double * box)) centre.det = 0;
  }
  const Vec3 from_a = 0.5 / centre.det * centre.numerator;
  if (!is_finite(from_a)) return {a, std::numeric_limits<double>::infinity()};
  return {a + from_a, length(from_a)};
}

Circumball circumball(const TetMesh& mesh, Tet t) {
  const auto& v = mesh.vertices[t];
  return circumball(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
}

std::vector<Circumball> circumballs(const TetMesh& mesh, unsigned threads) {
  std::vector<Circumball> balls(mesh.finite);
  parallel_for(mesh.finite, threads,
               [&](std::size_t t) { balls[t] = circumball(mesh, static_cast<Tet>(t)); });
  return balls;
}

std::vector<double> sample_spacing(const TetMesh& mesh, const Stars& stars, unsigned threads) {
  std::vector<double> raw(mesh.points.size()), spacing(mesh.points.size());
  std::vector<std::array<Index, spacing_rank>> ends(mesh.points.size());
  std::vector<std::uint8_t> counts(mesh.points.size());
  parallel_for(raw.size(), threads, [&](std::size_t v) {
    const Shortest shortest = shortest_edges(mesh, stars, static_cast<Index>(v));
    counts[v] = static_cast<std::uint8_t>(shortest.count);
    for (std::size_t k = 0; k < shortest.count; ++k) ends[v][k] = shortest.edges[k].end;
    raw[v] =
        std::max(std::sqrt(shortest.edges[shortest.count - 1].squared_length), smallest_spacing);
  });
  parallel_for(raw.size(), threads, [&](std::size_t v) {
    std::array<double, spacing_rank + 1> around;
    around[0] = raw[v];
    for (std::size_t k = 0; k < counts[v]; ++k) around[k + 1] = raw[ends[v][k]];
    const auto middle = around.begin() + counts[v] / 2;
    std::nth_element(around.begin(), middle, around.begin() + counts[v] + 1);
    spacing[v] = *middle;
  });
  return spacing;
}

TetBase largest_base(const TetMesh& mesh, Tet t) {
  std::array<Vec3, 4> x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = mesh.points[mesh.vertices[t][i]];
  const double volume6 = dot(cross(x[1] - x[0], x[2] - x[0]), x[3] - x[0]);
  double largest = 0;
  for (const auto& k : facet_corners) {
    const Vec3 a = x[static_cast<std::size_t>(k[0])];
    largest = std::max(largest, squared_length(cross(x[static_cast<std::size_t>(k[1])] - a,
                                                     x[static_cast<std::size_t>(k[2])] - a)));
  }
  const double twice_area = std::sqrt(largest);
  return {twice_area, largest > 0 ? std::abs(volume6) / twice_area : 0};
}

}  // namespace arris
