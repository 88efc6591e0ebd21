#include "cut/facet_costs.h"

#include <cmath>

#include "energy/distance.h"

namespace arris {

double facet_cost(const TetMesh& mesh, const EnergyModel& model,
                  const std::vector<double>& curvature, Tet t, int i) {
  const Tet n = mesh.neighbours[t][static_cast<std::size_t>(i)];
  if (n < t) return facet_cost(mesh, model, curvature, n, mesh.facet_to(n, t));
  if (!mesh.is_finite(t)) return 0;
  double h = 0, kappa = 0;
  for (int corner : facet_corners[static_cast<std::size_t>(i)]) {
    const Index v = mesh.vertices[t][static_cast<std::size_t>(corner)];
    h += model.spacing[v] / 3;
    if (!curvature.empty()) kappa += std::abs(curvature[v]) / 3;
  }
  const FacetDistance facet = facet_distance(mesh, t, i);
  return (facet.mean_distance / h + model.lambda * kappa * h) * facet.area / (h * h);
}

double surface_cost(const TetMesh& mesh, const EnergyModel& model,
                    const std::vector<double>& curvature, const Labels& labels) {
  double sum = 0;
  for (Tet t = 0; t < mesh.finite; ++t) {
    if (!labels[t]) continue;
    for (int i = 0; i < 4; ++i)
      if (!labels[mesh.neighbours[t][static_cast<std::size_t>(i)]])
        sum += facet_cost(mesh, model, curvature, t, i);
  }
  return sum;
}

}  // namespace arris
