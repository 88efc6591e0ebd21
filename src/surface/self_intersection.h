// Pairs of triangles of a mesh that meet where they should not.
#pragma once

#include <span>

#include "arris/types.h"
#include "base/job.h"
#include "surface/box_tree.h"
#include "surface/defects.h"

namespace arris {

// Counts the pairs of triangles of `tree` for which facets_meet; they must not be degenerate. The
// example is the lexicographically lowest pair of triangles. Ticks the job from `from` to 1.
// Throws Failure(cancelled).
// Complexity: O(n log n + k) for k pairs with overlapping boxes.
Defects find_intersections(std::span<const Vec3> points, std::span<const Triangle> triangles,
                           const BoxTree& tree, Job& job, double from);

}  // namespace arris
