// Splits the gaps of feature curves until the Delaunay triangulation has to follow them.
#pragma once

#include <vector>

#include "base/job.h"
#include "cloud/nearest.h"
#include "feature/candidates.h"

namespace arris {

// The gap between two consecutive feature points is an edge of the Delaunay triangulation if no
// point enters its diametral ball. Other gaps are split at the foot of the point that enters, as in
// conforming Delaunay refinement (Ruppert, "A Delaunay refinement algorithm for quality
// 2-dimensional mesh generation", 1995), and long ones in the middle, down to a least length.
// `marked` are samples that lie on features: ends of gaps, never added. Gaps that are sides of
// `mesh` are left alone; `nearest` finds the nearest of `points`. Appends to `features`. O(features
// log points).
void protect_curves(const std::vector<Vec3>& points, const NearestSample& nearest,
                    const FacetMesh& mesh, const std::vector<FeaturePoint>& marked,
                    std::vector<FeaturePoint>& features, Job& job);

}  // namespace arris
