// Where many votes speak against the few that were the strongest.
#pragma once

#include <cstdint>
#include <vector>

#include "seed/seeds.h"
#include "seed/votes.h"
#include "tetra/tet_mesh.h"

namespace arris {

// The forest of votes hangs a whole region on its single strongest vote. In a gap of the samples
// that vote may go through a wall that nobody saw. So regions are grown round tetrahedra that a
// refused vote speaks to, and those are turned to the other side that all votes at their rims,
// summed, want there (local search as of Fiduccia and Mattheyses, "A linear-time heuristic for
// improving network partitions", 1982). `firm`: 1 for large balls; regions of mostly small ones
// stay as they are, since their votes are noise. Labels of seed_free stay free. Returns how many
// tetrahedra were turned. Deterministic. O(tetrahedra), and O(s log s) for each of the regions
// tried, s their size, bounded in practice by `deepest_loss`.
std::size_t recount_votes(const TetMesh& mesh, const Votes& votes,
                          const std::vector<std::uint8_t>& firm, std::vector<Seed>& label);

}  // namespace arris
