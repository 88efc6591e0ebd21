#include "energy/curvature.h"

#include <algorithm>

#include "base/parallel.h"

namespace arris {
namespace {

// Calls visit(t, i) for every boundary facet of t, if t is inside.
template <class Visit>
void for_boundary_facets(const TetMesh& mesh, const Labels& labels, Tet t, Visit&& visit) {
  if (labels[t] == 0) return;
  for (int i = 0; i < 4; ++i)
    if (labels[mesh.neighbours[t][static_cast<std::size_t>(i)]] == 0) visit(t, i);
}

// Sum over the boundary edges of weight(u, v) x turning angle.
template <class Weight>
double sum_over_edges(const TetMesh& mesh, const Labels& labels, unsigned threads,
                      Weight&& weight) {
  const auto at_facet = [&](Tet t, int i) {
    double sum = 0;
    const Vec3 normal = facet_normal(mesh, t, i);
    const auto& corners = facet_corners[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < 3; ++k) {
      const int j = corners[k];  // the other facet of t at the edge opposite this corner
      const EdgeStep end = last_of_label(mesh, labels, {t, i, j});
      // Both ends of the wedge arrive here: count it from one of them.
      if (end.t < t || (end.t == t && end.out < i)) continue;
      const Index u = mesh.vertices[t][static_cast<std::size_t>(corners[(k + 1) % 3])];
      const Index v = mesh.vertices[t][static_cast<std::size_t>(corners[(k + 2) % 3])];
      sum += weight(u, v) * turning_angle(normal, facet_normal(mesh, end.t, end.out));
    }
    return sum;
  };
  return parallel_sum(mesh.finite, threads, [&](std::size_t t) {
    double sum = 0;
    for_boundary_facets(mesh, labels, static_cast<Tet>(t),
                        [&](Tet, int i) { sum += at_facet(static_cast<Tet>(t), i); });
    return sum;
  });
}

}  // namespace

double edge_cost(const TetMesh& mesh, const EnergyModel& model, Index u, Index v) {
  if (model.curvature == Curvature::area) return 0;
  const double h = 0.5 * (model.spacing[u] + model.spacing[v]);
  return 0.5 * model.lambda * distance(mesh.points[u], mesh.points[v]) / h;
}

std::array<VertexCurvature, 3> facet_curvature(const TetMesh& mesh, const EnergyModel& model, Tet t,
                                               int i) {
  const auto& corners = facet_corners[static_cast<std::size_t>(i)];
  std::array<Vec3, 3> x;
  double h = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Index v = mesh.vertices[t][static_cast<std::size_t>(corners[k])];
    x[k] = mesh.points[v];
    h += 1.0 / 3 * model.spacing[v];
  }
  const Vec3 normal = facet_normal(mesh, t, i);
  const double twice_area = length(normal);
  std::array<VertexCurvature, 3> result;
  if (twice_area == 0) return result;
  const Vec3 unit = 1 / twice_area * normal;
  const double area = 0.5 * twice_area;
  std::array<double, 3> cosine;  // of the angle at each corner, times the lengths of its two sides
  for (std::size_t k = 0; k < 3; ++k) cosine[k] = dot(x[(k + 1) % 3] - x[k], x[(k + 2) % 3] - x[k]);
  const bool obtuse = *std::min_element(cosine.begin(), cosine.end()) < 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 a = x[k], b = x[(k + 1) % 3], c = x[(k + 2) % 3];
    const double cot_b = cosine[(k + 1) % 3] / twice_area, cot_c = cosine[(k + 2) % 3] / twice_area;
    // cot(c)(a - b) + cot(b)(a - c) is the opposite side turned by a right angle: written so, it is
    // never longer than that side, however large the cotangents.
    result[k].turning = 0.5 * cross(unit, c - b);
    const double voronoi = 0.125 * (squared_length(a - b) * cot_c + squared_length(a - c) * cot_b);
    // A Voronoi share lies between a quarter and a half of the triangle unless rounding moved it.
    result[k].area =
        obtuse ? (cosine[k] < 0 ? 0.5 : 0.25) * area : std::clamp(voronoi, 0.25 * area, 0.5 * area);
    result[k].weight = area / (3 * h);
  }
  return result;
}

double total_mean_curvature(const TetMesh& mesh, const Labels& labels) {
  return sum_over_edges(mesh, labels, 1, [&](Index u, Index v) {
    return 0.5 * distance(mesh.points[u], mesh.points[v]);
  });
}

double polyhedral_energy(const TetMesh& mesh, const EnergyModel& model, const Labels& labels,
                         unsigned threads) {
  return sum_over_edges(mesh, labels, threads,
                        [&](Index u, Index v) { return edge_cost(mesh, model, u, v); });
}

double cotangent_energy(const TetMesh& mesh, const EnergyModel& model, const Labels& labels) {
  std::vector<VertexCurvature> at(mesh.points.size());
  const auto add_facet = [&](Tet t, int i) {
    const auto terms = facet_curvature(mesh, model, t, i);
    for (std::size_t k = 0; k < 3; ++k) {
      const int corner = facet_corners[static_cast<std::size_t>(i)][k];
      at[mesh.vertices[t][static_cast<std::size_t>(corner)]] += terms[k];
    }
  };
  for (Tet t = 0; t < mesh.finite; ++t) for_boundary_facets(mesh, labels, t, add_facet);
  double sum = 0;
  for (const VertexCurvature& v : at) sum += v.cost(model);
  return sum;
}

}  // namespace arris
