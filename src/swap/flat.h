// Tetrahedra too flat for their flip to change the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "tetra/tet_mesh.h"

namespace arris {

// 1 for every finite tetrahedron that is a sliver, lower than sliver_height: for
// SwapOptions::frozen. The energy of its two sides differs by rounding alone, and a swap would
// trade good triangles for needles along sharp edges: without this, swaps on the sampled edges of a
// dodecahedron, which were exact after the cut, took the strict edge F1 from 1.00 to 0.98.
std::vector<std::uint8_t> flat_tetrahedra(const TetMesh& mesh, const std::vector<double>& spacing,
                                          unsigned threads);

}  // namespace arris
