// Tetrahedra too flat for their flip to change the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "tetra/tet_mesh.h"

namespace arris {

// 1 for every finite tetrahedron whose least height is below a thousandth of the spacing at its
// corners, e.g. four samples of one plane: for SwapOptions::frozen. The energy of their two sides
// differs by rounding alone, and a swap would trade good triangles for needles along sharp edges.
std::vector<std::uint8_t> flat_tetrahedra(const TetMesh& mesh, const std::vector<double>& spacing,
                                          unsigned threads);

}  // namespace arris
