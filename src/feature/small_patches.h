// Patches too small to be meant: what noise and bevels cut out between lines side by side.
#pragma once

#include "feature/network.h"

namespace arris {

// Joins every patch of fewer triangles than surround one vertex with the neighbour from which the
// weakest line parts it, by taking that line out of the network; so a cluster of noise dissolves,
// and of lines that run side by side the sharpest stays. Patches that look like the facets of a
// coarse polyhedron are kept: flat ones of two or more triangles, and single triangles that are
// sharp all round, unless they lie beside a patch of many triangles. O(n) a round, a few rounds.
void merge_small_patches(Network& network);

}  // namespace arris
