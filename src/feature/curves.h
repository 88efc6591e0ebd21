// From the edges of the network to its curves and corners.
#pragma once

#include "arris/features.h"
#include "feature/network.h"

namespace arris {

// Fills `curves` and `corners` of the result. A curve runs between vertices where another number
// of edges than two meet, or where a line bends sharply; a closed curve has neither. O(n).
void trace_curves(const Mesh& mesh, const Network& network, FeatureNetwork& result);

}  // namespace arris
