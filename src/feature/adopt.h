// Samples that lie exactly on planes sensed near them belong to these, though nothing was sensed
// round them: at the walls of a gap in a narrow wedge no facet shows where the surface goes.
#pragma once

#include <cstdint>
#include <vector>

#include "feature/facets.h"
#include "feature/local_surface.h"

namespace arris {

// Appends to surfaces[v] of each point with open[v] = 1, which must have none, the planes of the
// points within two rings, known to two of them, that it lies on more exactly than chance would
// have it; what was adopted is handed on. For clean samples. `spacing`: h > 0 per point. O(open
// points), sequential.
void adopt_planes(const std::vector<Vec3>& points, const FacetMesh& mesh,
                  const std::vector<double>& spacing, const std::vector<std::uint8_t>& open,
                  std::vector<std::vector<LocalSurface>>& surfaces);

}  // namespace arris
