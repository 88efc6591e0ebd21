// Most clouds have no outliers, which takes less to see than to find some.
#pragma once

#include <vector>

#include "arris/types.h"
#include "base/job.h"

namespace arris {

// Whether every point of a cloud of more than Neighbours::count distinct ones keeps company like
// its own and all are linked, so that find_outliers finds none. False says nothing. O(n log n),
// parallel but for the links; 50 bytes a point.
bool has_no_outliers(const std::vector<Vec3>& points, Job& job);

}  // namespace arris
