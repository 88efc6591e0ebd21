// Splits the gaps of feature curves until the Delaunay triangulation has to follow them.
#pragma once

#include <vector>

#include "feature/feature_points.h"

namespace arris {

// A gap between consecutive feature points that no sample enters with its diametral ball is an edge
// of the Delaunay triangulation. Others are split at the foot of the sample that enters (as in
// conforming Delaunay refinement: Ruppert 1995; Shewchuk 2002). Appends to `features`.
void protect_curves(const std::vector<Vec3>& points, std::vector<FeaturePoint>& features, Job& job);

}  // namespace arris
