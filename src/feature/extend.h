// What planes that were carried on across a gap of the samples say of the tetrahedra there.
#pragma once

#include <vector>

#include "feature/candidates.h"
#include "seed/seeds.h"
#include "tetra/tet_mesh.h"

namespace arris {

// The points of `features` from number `known` on are the last points of the mesh. At those across
// a gap (FeaturePoint::gap) no tetrahedron is firm. One whose corners all lie on the planes there,
// near the gap, fills what they enclose: it prefers to be inside if it is behind convex planes,
// outside if it is before concave ones. Others keep their label as a hint. O(tetrahedra).
void extend_across_gaps(const TetMesh& mesh, const std::vector<FeaturePoint>& features,
                        std::size_t known, Seeds& seeds);

}  // namespace arris
