// The step of the pipeline that adds points on the smooth surface between the samples.
#pragma once

#include "stage.h"

namespace arris {

// Adds the points that the surface of `labels` lets sense, and cuts anew, with
// swaps where the surface turns sharply; elsewhere they would undo what is gained. Points near
// which the new surface leaves a vertex out, old or new, are taken back if the topology of the
// surface is not what it was; if that does not mend it the stage stays as it was. Returns the
// number of points added.
std::size_t refine_surface(const Samples& samples, Stage& stage, Labels& labels, Report& report,
                           Job& job);

}  // namespace arris
