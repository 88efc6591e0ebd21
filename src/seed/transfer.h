// Seeds for one tetrahedral mesh from the labels of another over the same samples.
#pragma once

#include "seed/seeds.h"
#include "tetra/tet_mesh.h"

namespace arris {

// A tetrahedron of `fine` takes the label of the tetrahedron of `coarse` that holds its centroid.
// It is firm if it has an added point (which lies well away from the samples) and all its added
// points lie on that same side. Confidence and contradiction are those of `seeds`.
// Complexity: near-linear, as both meshes are numbered along the same curve.
Seeds transfer_seeds(const TetMesh& coarse, const Labels& labels, const Seeds& seeds,
                     const TetMesh& fine, Job& job);

}  // namespace arris
