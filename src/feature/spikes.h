// Samples that a first surface passes through, or leaves aside, though the surface round them goes
// on without them: outliers near the surface, which no density tells from samples.
#pragma once

#include <cstdint>
#include <vector>

#include "arris/types.h"
#include "base/job.h"

namespace arris {

// One per point: 1 for a spike. `triangles` index `points`; `spacing` > 0 per point. A point is
// explained by a triangle near it that does not touch it if it lies in the plane of that triangle.
// What is left unexplained, the distance to the nearest of those planes in units of spacing, is
// small for a sample of a smooth surface, near an edge, corner or tip (there is a triangle on
// either side), and comparable with its neighbours' where there is noise or the sampling is
// coarse. A spike is left unexplained by far more than its neighbours are.
// Complexity: O(n), parallel, O(n log n) for points that no triangle touches; 40 bytes a point.
std::vector<std::uint8_t> find_spikes(const std::vector<Vec3>& points,
                                      const std::vector<Triangle>& triangles,
                                      const std::vector<double>& spacing, Job& job);

}  // namespace arris
