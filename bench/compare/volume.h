// The share of volume that two solids have in common.
#pragma once

#include "base/job.h"
#include "compare/compare.h"
#include "compare/surface.h"

namespace arris::compare {

// How inside is told from outside: by the parity of crossings, or, for a surface that is
// consistently oriented and crosses itself, by a winding number other than 0.
enum class InsideRule { parity, winding };

struct Solid {
  const Surface& surface;
  InsideRule rule;
};

// Volume of the intersection over that of the union, by lines along all three axes at jittered
// positions on a grid: along each the solids are exact intervals. Undefined if the union is empty.
// Both surfaces must have an even number of triangles at every edge. Ticks the job from 0 to 1;
// throws Failure(cancelled). Deviation: that of `options.samples` lines.
double volume_iou(const Solid& result, const Solid& truth, const CompareOptions& options, Job& job);

}  // namespace arris::compare
