// Pairs of triangles of a mesh that meet where they should not.
#pragma once

#include <cstdint>
#include <span>

#include "arris/types.h"
#include "base/job.h"
#include "surface/box_tree.h"
#include "surface/defects.h"

namespace arris {

struct Intersections {
  Defects pairs;             // the example is the lexicographically lowest pair of triangles
  std::uint64_t tested = 0;  // pairs for which facets_meet was asked
};

// How the search goes, not what it finds.
struct CrowdLimits {
  // A triangle whose box overlaps more others is crowded: a long one, or one amidst long ones.
  std::size_t most_near = 256;
  // A corner of so many crowded triangles is a hub, the tip of a fan.
  std::size_t least_hub = 64;
};

// Counts the pairs of triangles of `tree` for which facets_meet; they must not be degenerate. Ticks
// the job from `from` to 1. Throws Failure(cancelled).
// Pairs with one that is not crowded are sought by axis-parallel boxes. The others: pairs that
// share a hub by their arcs round it (StarArcs), those that do not by oriented boxes
// (OrientedTree). Complexity: O(n log² n + k) for k pairs whose boxes, or arcs, overlap along all
// axes tried; whatever the degrees of the vertices.
Intersections find_intersections(std::span<const Vec3> points, std::span<const Triangle> triangles,
                                 const BoxTree& tree, Job& job, double from,
                                 const CrowdLimits& limits = {});

}  // namespace arris
