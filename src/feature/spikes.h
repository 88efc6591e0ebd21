// Samples that a first surface passes through, or leaves aside, though the surface round them goes
// on without them: outliers so near the surface that no density tells them from samples.
#pragma once

#include <cstdint>
#include <vector>

#include "arris/types.h"
#include "base/job.h"

namespace arris {

// One per point: 1 for a spike. `triangles` index `points`; `spacing` > 0 per point. A point is
// explained by a triangle near it, but not at it, in whose plane it lies. How far it is from the
// nearest of those planes, in units of spacing, is small for a sample of a smooth surface, at an
// edge, a corner or a tip (they have triangles on each of their sides), and as large as for its
// neighbours and the rest of the cloud where there is noise. For a spike it is many times larger.
// Complexity: O(n), parallel; O(log n) more for each point that no triangle touches. 40 bytes a
// point. The same result for every number of threads.
std::vector<std::uint8_t> find_spikes(const std::vector<Vec3>& points,
                                      const std::vector<Triangle>& triangles,
                                      const std::vector<double>& spacing, Job& job);

}  // namespace arris
