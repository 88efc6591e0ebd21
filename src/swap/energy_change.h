// What the flip of one tetrahedron does to E.
#pragma once

#include "energy/facet.h"
#include "energy/model.h"
#include "swap/boundary.h"

namespace arris {

// A difference of sums, with the size of what was summed, against which rounding is judged.
struct Change {
  double value = 0;
  double magnitude = 0;

  void add(double term, double sign) {
    value += sign * term;
    magnitude += term;
  }
  Change& operator+=(const Change& o) {
    value += o.value;
    magnitude += o.magnitude;
    return *this;
  }
  // E falls by more than rounding can pretend: some hundred terms of relative error 2^-53 each.
  bool lowers() const {
    constexpr double rounding = 1e-12;
    return value < -rounding * magnitude;
  }
};

// E after a flip of t, less E before. The flip must be simple.
// Complexity: six edges (polyhedral) or four vertices (cotangent) of the surface, with the
// tetrahedra round them.
Change flip_change(const Boundary& boundary, const EnergyModel& model,
                   const FidelityCosts& fidelity, Tet t);

}  // namespace arris
