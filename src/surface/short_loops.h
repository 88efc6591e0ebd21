// Short loops round handles and through tunnels, after
//   Erickson, Whittlesey: Greedy optimal homotopy and homology generators (SODA 2005).
#pragma once

#include <vector>

#include "arris/types.h"
#include "feature/facets.h"

namespace arris {

// Closed walks along sides of a closed surface that are not the boundary of any piece of it, of at
// most `most_sides` sides, each no longer than `longest` times the mean spacing of its ends. Short
// ones first, and none that shares a point with one before, or goes round the same handle (that is,
// both together bound a piece). Sides that a tree of sides and a tree
// of facets leave over, two for each handle, get random bits; what a loop crosses of them tells
// whether it bounds (wrongly with a chance of 2^-64). Deterministic. O(points + facets), and a walk
// of most_sides / 2 rings round each point beside such a loop.
std::vector<std::vector<Index>> short_loops(const FacetMesh& mesh, const std::vector<Vec3>& points,
                                            const std::vector<double>& spacing, int most_sides,
                                            double longest);

// Sides of the shortest loop that crosses this one once: one more than the shortest way along sides
// from its left to its right that keeps off it, and one at either end. most + 1 if it has more than
// that. O(points within most rings).
int sides_across(const FacetMesh& mesh, const std::vector<Index>& loop, int most);

}  // namespace arris
