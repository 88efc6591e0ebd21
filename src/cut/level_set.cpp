#include "cut/level_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "base/vec.h"

namespace arris {
namespace {

// Squared distance from p to the triangle abc (Ericson, "Real-Time Collision Detection", 5.1.5).
double squared_distance(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return squared_length(ap);
  const Vec3 bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return squared_length(bp);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return squared_length(ap - d1 / (d1 - d3) * ab);
  const Vec3 cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return squared_length(cp);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return squared_length(ap - d2 / (d2 - d6) * ac);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return squared_length(bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b));
  const double scale = 1 / (va + vb + vc);
  return squared_length(ap - vb * scale * ab - vc * scale * ac);
}

// Spreads surface facets (numbered 4 t + i, t inside) over the edges of the mesh.
class Spreading {
 public:
  Spreading(const TetMesh& mesh, const Stars& stars, const Labels& labels)
      : mesh_(mesh),
        stars_(stars),
        facet_(mesh.points.size(), no_index),
        squared_(mesh.points.size(), std::numeric_limits<double>::infinity()) {
    for (Tet t = 0; t < mesh.finite; ++t) {
      if (!labels[t]) continue;
      for (std::uint32_t i = 0; i < 4; ++i) {
        const Tet n = mesh.neighbours[t][i];
        if (labels[n]) continue;
        for (Tet side : {t, n})
          for (Index v : mesh.vertices[side]) offer(v, 4 * t + i);
      }
    }
  }

  void run(Job& job) {
    std::vector<std::size_t> asked(mesh_.points.size(), 0);  // in which step, each vertex once
    for (std::size_t k = 1; !queue_.empty(); ++k) {
      if (k % 65536 == 0) job.tick(0.5);
      const auto [squared, v, facet] = queue_.top();
      queue_.pop();
      if (facet != facet_[v]) continue;
      for (Tet t : stars_[v])
        for (Index w : mesh_.vertices[t]) {
          if (w == infinite_vertex || asked[w] == k) continue;
          asked[w] = k;
          offer(w, facet);
        }
    }
  }

  const std::vector<double>& squared() const { return squared_; }

 private:
  void offer(Index v, std::uint32_t facet) {
    if (v == infinite_vertex || facet_[v] == facet) return;
    const auto& corners = facet_corners[facet % 4];
    const auto at = [&](int c) {
      return mesh_.points[mesh_.vertices[facet / 4][static_cast<std::size_t>(c)]];
    };
    const double d =
        squared_distance(mesh_.points[v], at(corners[0]), at(corners[1]), at(corners[2]));
    if (d >= squared_[v]) return;
    squared_[v] = d;
    facet_[v] = facet;
    queue_.push({d, v, facet});
  }

  using Entry = std::tuple<double, Index, std::uint32_t>;
  const TetMesh& mesh_;
  const Stars& stars_;
  std::vector<std::uint32_t> facet_;
  std::vector<double> squared_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

// Gradients of the four linear hat functions of a tetrahedron, and its volume.
struct Element {
  std::array<Vec3, 4> hat;
  double volume = 0;
};

Element make_element(const TetMesh& mesh, Tet t) {
  Element e;
  std::array<Vec3, 4> x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = mesh.points[mesh.vertices[t][i]];
  e.volume = dot(cross(x[1] - x[0], x[2] - x[0]), x[3] - x[0]) / 6;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& k = facet_corners[i];
    const Vec3 a = x[static_cast<std::size_t>(k[0])], b = x[static_cast<std::size_t>(k[1])],
               c = x[static_cast<std::size_t>(k[2])];
    e.hat[i] = -1 / (6 * e.volume) * cross(b - a, c - a);  // inward: towards vertex i
  }
  return e;
}

}  // namespace

std::vector<double> signed_distance(const TetMesh& mesh, const Stars& stars, const Labels& labels,
                                    Job& job) {
  Spreading spreading(mesh, stars, labels);
  spreading.run(job);
  std::vector<double> distance(mesh.points.size());
  for (std::size_t v = 0; v < distance.size(); ++v) distance[v] = std::sqrt(spreading.squared()[v]);
  // A point off the surface has a star of one label; on the surface the sign does not matter.
  for (Tet t = 0; t < mesh.finite; ++t)
    if (labels[t])
      for (Index v : mesh.vertices[t]) distance[v] = -std::abs(distance[v]);
  return distance;
}

std::vector<double> level_set_curvature(const TetMesh& mesh, const std::vector<double>& distance) {
  std::vector<double> flux(mesh.points.size(), 0), volume(mesh.points.size(), 0);
  for (Tet t = 0; t < mesh.finite; ++t) {
    const Element e = make_element(mesh, t);
    const auto& corners = mesh.vertices[t];
    Vec3 gradient;  // by differences: exactly 0 where the distance is constant
    for (std::size_t i = 1; i < 4; ++i)
      gradient = gradient + (distance[corners[i]] - distance[corners[0]]) * e.hat[i];
    const double norm = length(gradient);
    if (!(norm > 0) || !std::isfinite(norm) || !(e.volume > 0)) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      const Index v = corners[i];
      // Weak form: the divergence tested with the hat function of v, by parts.
      flux[v] -= e.volume * dot(e.hat[i], 1 / norm * gradient);
      volume[v] += e.volume / 4;
    }
  }
  for (std::size_t v = 0; v < flux.size(); ++v) flux[v] = volume[v] > 0 ? flux[v] / volume[v] : 0;
  return flux;
}

}  // namespace arris
