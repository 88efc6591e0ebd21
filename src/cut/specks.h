// Parts of the solid, or voids in it, too small for the sampling to have meant them.
#pragma once

#include <cstdint>
#include <vector>

#include "tetra/tet_mesh.h"

namespace arris {

// Relabels every connected part (through facets) whose volume is below that of a ball of one
// spacing: where two sheets meet in a taper, or round outliers, a handful of samples encloses a few
// tetrahedra by chance, while a part that the samples resolve holds a ball of 1.5 spacings. The
// largest part inside always stays. A 2-manifold boundary stays one. Returns the number of parts.
// Complexity: O(tetrahedra).
std::uint64_t remove_specks(const TetMesh& mesh, const std::vector<double>& spacing,
                            Labels& labels);

}  // namespace arris
