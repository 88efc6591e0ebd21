// The steps of find_features, for callers inside the library.
#pragma once

#include "arris/features.h"
#include "base/job.h"

namespace arris {

// As the public find_features, within the current stage of `job`. The mesh must be sound: valid
// corners, finite coordinates. Throws Failure(cancelled).
FeatureNetwork feature_network(const Mesh& mesh, Job& job);

}  // namespace arris
