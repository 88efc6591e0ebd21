// The steps of find_features, for callers inside the library.
#pragma once

#include "arris/features.h"
#include "base/job.h"
#include "feature/network.h"

namespace arris {

// The sharp edges alone. Holds on to `mesh` and `edges`. O(n log n).
Network crease_network(const Mesh& mesh, const MeshEdges& edges, Job& job);

// As the public find_features, within the current stage of `job`. The mesh must be sound: valid
// corners, finite coordinates. Throws Failure(cancelled).
FeatureNetwork feature_network(const Mesh& mesh, Job& job);

}  // namespace arris
