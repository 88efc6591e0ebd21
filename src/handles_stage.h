// The step of the pipeline that mends handles too small to be there.
#pragma once

#include "stage.h"

namespace arris {

// Where evidence for inside and outside gives out (the tip of a wedge, walls thinner than the
// noise) the surface gets pinholes and bridges that a loop of a few sides goes round
// (surface/short_loops.h). The disc that such a loop spans lies in the void, and is filled, or in
// the solid, and is cut: tetrahedra that it crosses change their label, then the surface is made a
// manifold again. Changes that do not leave a handle less are tried once more on a thicker disc,
// and else taken back. O(tetrahedra) if there are handles, O(facets) if there are none.
void mend_handles(Stage& stage, Labels& labels, Report& report, Job& job);

}  // namespace arris
