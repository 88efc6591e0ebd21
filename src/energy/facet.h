// What one facet contributes to E. Each quantity is computed from the same one of the two
// tetrahedra at the facet, whichever side asks, so E is a function of the labels to the last bit
// and a sequence of moves that lower it cannot run in a circle.
#pragma once

#include <vector>

#include "base/parallel.h"
#include "energy/distance.h"
#include "energy/model.h"
#include "tetra/tet_mesh.h"

namespace arris {

// Normal of facet i of t that points out of t, twice the area long. The facet must not be infinite.
Vec3 facet_normal(const TetMesh& mesh, Tet t, int i);

// d S / h^3 of the facet: its share of the fidelity term (paper, eq. 3 and 5). With Curvature::area
// also λ S / h^2, which makes it all of E. Dimensionless.
double fidelity_cost(const TetMesh& mesh, const EnergyModel& model, Tet t, int i);

// fidelity_cost with a memory: each facet is computed once. 32 bytes a tetrahedron.
class FidelityCosts {
 public:
  // Holds on to both. Nothing is known at first.
  FidelityCosts(const TetMesh& mesh, const EnergyModel& model);

  const TetMesh& mesh() const noexcept { return mesh_; }
  const EnergyModel& model() const noexcept { return model_; }

  // Cost of facet i of t. Not the same facet for several threads at once, unless it is known.
  double operator()(Tet t, int i) const;

  // Makes the facets of all tetrahedra known for which wanted(t).
  template <class Wanted>
  void fill(unsigned threads, Wanted&& wanted) {
    parallel_for(mesh_.finite, threads, [&](std::size_t k) {
      const auto t = static_cast<Tet>(k);
      for (int i = 0; i < 4; ++i) {  // each facet by its lower side alone
        const Tet n = mesh_.neighbours[t][static_cast<std::size_t>(i)];
        if (n > t && (wanted(t) || (mesh_.is_finite(n) && wanted(n)))) (*this)(t, i);
      }
    });
  }

 private:
  const TetMesh& mesh_;
  const EnergyModel& model_;
  mutable std::vector<double> cost_;  // [4 t + i], t < neighbour; negative if not yet known
};

}  // namespace arris
