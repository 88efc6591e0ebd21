// What a user may want to know of the finished mesh: which faces are filled, and its features.
#pragma once

#include <vector>

#include "arris/reconstruct.h"
#include "base/job.h"
#include "cloud/prepare.h"

namespace arris {

// Share of the whole time, for the progress bar.
inline constexpr double describe_share = 0.05;

// Fills in support, filled and features of a result with a certified closed mesh, and their counts.
// With Options::trim it also takes the filled faces away and certifies what is left. `spacing` is
// that of the samples, perhaps followed by that of other points. Throws Failure: no_surface (no
// face is supported), certificate (the open mesh is not sound), cancelled. O(n log n).
void describe_surface(const Samples& samples, const std::vector<double>& spacing,
                      Reconstruction& result, Job& job);

}  // namespace arris
