#include "cut/facet_costs.h"

#include <cmath>

#include "base/vec.h"
#include "energy/facet.h"

namespace arris {

double facet_cost(const TetMesh& mesh, const EnergyModel& model,
                  const std::vector<double>& curvature, Tet t, int i) {
  const Tet n = mesh.neighbours[t][static_cast<std::size_t>(i)];
  if (n < t) return facet_cost(mesh, model, curvature, n, mesh.facet_to(n, t));
  if (!mesh.is_finite(t)) return 0;
  const double fidelity = fidelity_cost(mesh, model, t, i);
  if (curvature.empty() || model.curvature == Curvature::area) return fidelity;
  double h = 0, kappa = 0;
  for (int corner : facet_corners[static_cast<std::size_t>(i)]) {
    const Index v = mesh.vertices[t][static_cast<std::size_t>(corner)];
    h += 1.0 / 3 * model.spacing[v];
    kappa += 1.0 / 3 * std::abs(curvature[v]);
  }
  const double area = 0.5 * length(facet_normal(mesh, t, i));
  return fidelity + model.lambda * kappa * area / h;
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
