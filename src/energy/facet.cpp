#include "energy/facet.h"

#include "base/vec.h"

namespace arris {

Vec3 facet_normal(const TetMesh& mesh, Tet t, int i) {
  const Tet n = mesh.neighbours[t][static_cast<std::size_t>(i)];
  const bool mine = t < n;
  const Tet owner = mine ? t : n;
  const auto& corners = facet_corners[static_cast<std::size_t>(mine ? i : mesh.facet_to(n, t))];
  const auto x = [&](std::size_t k) {
    return mesh.points[mesh.vertices[owner][static_cast<std::size_t>(corners[k])]];
  };
  const Vec3 a = x(0), normal = cross(x(1) - a, x(2) - a);
  return mine ? normal : -normal;
}

double fidelity_cost(const TetMesh& mesh, const EnergyModel& model, Tet t, int i) {
  const Tet n = mesh.neighbours[t][static_cast<std::size_t>(i)];
  if (n < t) return fidelity_cost(mesh, model, n, mesh.facet_to(n, t));
  double h = 0;
  for (int corner : facet_corners[static_cast<std::size_t>(i)])
    h += 1.0 / 3 * model.spacing[mesh.vertices[t][static_cast<std::size_t>(corner)]];
  const FacetDistance f = facet_distance(mesh, t, i);
  const double constant = model.curvature == Curvature::area ? model.lambda * h : 0;
  return (f.mean_distance + constant) * f.area / (h * h * h);
}

FidelityCosts::FidelityCosts(const TetMesh& mesh, const EnergyModel& model)
    : mesh_(mesh), model_(model), cost_(4 * mesh.finite, -1) {}

double FidelityCosts::operator()(Tet t, int i) const {
  const Tet n = mesh_.neighbours[t][static_cast<std::size_t>(i)];
  if (n < t) return (*this)(n, mesh_.facet_to(n, t));
  double& cost = cost_[4 * static_cast<std::size_t>(t) + static_cast<std::size_t>(i)];
  if (cost < 0) cost = fidelity_cost(mesh_, model_, t, i);
  return cost;
}

}  // namespace arris
