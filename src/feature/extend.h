// What planes that were carried on across a gap of the samples say of the tetrahedra there.
#pragma once

#include <vector>

#include "feature/candidates.h"
#include "seed/seeds.h"
#include "tetra/tet_mesh.h"

namespace arris {

// `added`: the feature points that are the last points of the mesh. At those that lie across a gap
// (FeaturePoint::gap), a tetrahedron whose corners all lie on the planes there fills the corner that
// they make: it is inside behind convex planes, outside before concave ones. What else there is at
// such a point is left to the cut: the label that it had is only a hint. O(tetrahedra).
void extend_across_gaps(const TetMesh& mesh, const std::vector<FeaturePoint>& features,
                        std::size_t known, Seeds& seeds);

}  // namespace arris
