// What one facet contributes to E. Each quantity is computed from the same one of the two
// tetrahedra at the facet, whichever side asks, so E is a function of the labels to the last bit
// and a sequence of moves that lower it cannot run in a circle.
#pragma once

#include "energy/distance.h"
#include "energy/model.h"
#include "tetra/tet_mesh.h"

namespace arris {

// Normal of facet i of t that points out of t, twice the area long. The facet must not be infinite.
Vec3 facet_normal(const TetMesh& mesh, Tet t, int i);

// d S / h^3 of the facet: its share of the fidelity term (paper, eq. 3 and 5). Dimensionless.
double fidelity_cost(const TetMesh& mesh, const EnergyModel& model, Tet t, int i);

}  // namespace arris
