// What each facet costs in the surface: the integrand of eq. 4 and 6, dimensionless.
#pragma once

#include <vector>

#include "energy/model.h"
#include "tetra/tet_mesh.h"

namespace arris {

// (d + λ|κ|) S of facet i of tetrahedron t, in units of the local spacing. `curvature` is κ per
// point in units of 1 / length, or empty for κ = 0; it counts for nothing with Curvature::area. The
// same from both sides of a facet; 0 on a facet with an infinite tetrahedron on both sides. O(1).
double facet_cost(const TetMesh& mesh, const EnergyModel& model,
                  const std::vector<double>& curvature, Tet t, int i);

// Sum of the costs of the facets between inside and outside. O(tetrahedra).
double surface_cost(const TetMesh& mesh, const EnergyModel& model,
                    const std::vector<double>& curvature, const Labels& labels);

}  // namespace arris
