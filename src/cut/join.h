// Where the sides of a bar are missing all round: its stumps are joined.
#pragma once

#include <cstddef>
#include <vector>

#include "base/job.h"
#include "tetra/tet_mesh.h"

namespace arris {

// Votes close a gap wherever the void reaches, so they cap both stumps of a bar whose sides are
// missing all round. Where two such caps face each other (stumps.h), what is between them is
// inside, and the surface there is cut anew without votes: of all surfaces that join on to the rest
// the one of least area and least lean from the surface at its corners, which carries that on
// (docs/method.md, gaps). `spacing` is h per sample; every point must be a sample. Tetrahedra at
// facets outside the caps keep their labels. Returns how many joins there are: the surface should
// have 2 less of the Euler characteristic for each, but need not be a manifold, nor succeed where
// another part is near. Deterministic. Throws Failure(cancelled). O(tetrahedra), and a minimum cut
// if there are stumps.
std::size_t join_stumps(const TetMesh& mesh, const std::vector<double>& spacing, Labels& labels,
                        Job& job);

}  // namespace arris
