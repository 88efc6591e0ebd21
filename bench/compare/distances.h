// Distances and normal errors from samples of one surface to another.
#pragma once

#include "base/job.h"
#include "compare/compare.h"
#include "compare/surface.h"

namespace arris::compare {

// `stream` keeps the draws of the two directions apart. Ticks the job from `from` to `to`.
// Throws Failure(cancelled).
Directed directed_distances(const Surface& surface, const Surface& other,
                            const CompareOptions& options, std::uint64_t stream, Job& job,
                            double from, double to);

// F1 of the two shares: undefined if both are, 0 if one of them is 0 or undefined.
Score score(double precision, double recall);

}  // namespace arris::compare
