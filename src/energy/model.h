// The energy E(Γ) = ∫_Γ (d + λ|κ|) ds of the paper (eq. 3), made dimensionless: every length is
// measured in units of the local sample spacing h, so λ means the same at every scale.
#pragma once

#include <span>
#include <vector>

#include "arris/options.h"
#include "arris/types.h"

namespace arris {

// Outward unit normals of the smooth surfaces that meet at each point: normal[first[v] ..
// first[v+1]); empty: nothing is known of any point.
struct Sides {
  std::vector<Vec3> normal;
  std::vector<Index> first;

  std::span<const Vec3> at(Index v) const noexcept {
    return {normal.data() + first[v], normal.data() + first[v + 1]};
  }
};

// The parameters of E that every stage shares. A facet f of area S and mean distance d costs
// d S / h_f^3, h_f the mean spacing of its three vertices; an edge of length l and exterior angle
// β costs λ (l β / 2) / h_e, h_e the mean spacing of its two; cotangent curvature alike.
// With Curvature::area a facet costs (d + λ h_f) S / h_f^3, and an edge nothing.
// Where sides are known, a facet pays for leaning from them, too (docs/method.md, features).
struct EnergyModel {
  double lambda = 0.1;                          // in units of h^2, or of h with area
  Curvature curvature = Curvature::polyhedral;  // never by_method here
  std::vector<double> spacing = {};             // h > 0 at every point of the TetMesh
  Sides sides = {};                             // empty before features are sensed
};

}  // namespace arris
