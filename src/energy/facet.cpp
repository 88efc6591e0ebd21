#include "energy/facet.h"

#include <algorithm>

#include "base/vec.h"

namespace arris {
namespace {

// Weight of a facet at right angles to all sides against one a spacing away from all samples.
// Measured: 0.3 to 10 give the same surface, 0 cuts corners off.
constexpr double lean_weight = 1;

// Mean over the corners, as far as known, of the squared sine between the facet and that side of
// the corner to which it is nearest.
double lean(const TetMesh& mesh, const EnergyModel& model, Tet t, int i) {
  if (model.sides.first.empty()) return 0;
  const Vec3 n = facet_normal(mesh, t, i);
  const double nn = squared_length(n);
  if (!(nn > 0)) return 0;
  double sum = 0;
  int known = 0;
  for (int corner : facet_corners[static_cast<std::size_t>(i)]) {
    const Index v = mesh.vertices[t][static_cast<std::size_t>(corner)];
    double best = -1;
    for (Index s = model.sides.first[v]; s < model.sides.first[v + 1]; ++s) {
      const double c = dot(n, model.sides.normal[s]);
      best = std::max(best, c * c / nn);
    }
    if (best < 0) continue;
    ++known;
    sum += 1 - best;
  }
  return known ? sum / known : 0;
}

}  // namespace

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
  const double distance = f.mean_distance / h;
  const double constant = model.curvature == Curvature::area ? model.lambda : 0;
  return (distance + lean_weight * lean(mesh, model, t, i) + constant) * f.area / (h * h);
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
