// The step of the pipeline that adds points on the smooth surface between the samples.
#pragma once

#include "stage.h"

namespace arris {

// Adds the points that the surface of `labels` lets sense, and cuts anew; then again over edges
// whose sag is still large. Points near which a new surface leaves a vertex out, old or new, are
// taken back if its topology is not what it was; if that does not mend it the stage stays as it
// was. At last swaps are made where the surface turns sharply; elsewhere they would undo what is
// gained. Returns the number of points added.
std::size_t refine_surface(const Samples& samples, Stage& stage, Labels& labels, Report& report,
                           Job& job);

// The same once, and only across the gaps of random samples, if there are many.
std::size_t fill_gaps(const Samples& samples, Stage& stage, Labels& labels, Report& report,
                      Job& job);

}  // namespace arris
