// How much noise a cloud has, place by place, from the samples alone.
//
// The deviation of a small neighbourhood from its best quadric is the noise plus what the quadric
// cannot follow. Noise does not depend on the size of the neighbourhood, while what a quadric
// misses grows with it: at least linearly (an edge), with the third power where the surface is
// smooth. Two sizes therefore tell one from the other. The idea is that of difference estimators of
// a variance (Gasser, Sroka, Jennen-Steinmetz, Residual variance and residual pattern in nonlinear
// regression, 1986), here with quadrics and pooled by a quantile, so that edges nearby do not
// count.
#pragma once

#include <vector>

#include "arris/types.h"
#include "base/job.h"
#include "cloud/nearest.h"

namespace arris {

// Standard deviation of the noise along the surface normal at every point, in the unit of the
// points; 0 where there is none worth a correction (below 0.004 of the spacing). `tree` is that of
// the points. Complexity: O(n log n); a clean cloud whose points come along a space-filling curve
// is mostly known by a sample of them.
std::vector<double> estimate_noise(const std::vector<Vec3>& points, const NearestSample& tree,
                                   Job& job);

}  // namespace arris
