// The topology of closed surfaces, and where it changes from one to the next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arris/types.h"

namespace arris {

struct Topology {
  std::size_t components;
  std::int64_t euler;
  bool operator==(const Topology&) const = default;
};

// Of a closed 2-manifold; corners are below `points`. O(points + triangles).
Topology topology_of(const std::vector<Triangle>& triangles, std::size_t points);

// A region is a set of points joined by facets that only one of two surfaces has. Since vertices,
// sides and facets are counted, the Euler characteristic changes by the sum of what it changes by
// in each region; together with the components that meet the region that makes the handles added.
// Two regions that join the same two components together add one, which neither is blamed for; nor
// is one that gets a handle and a component at once where no other region changes.
struct ChangedRegions {
  std::vector<Index> of;              // per point: its region, or no_index where nothing changed
  std::vector<std::int64_t> handles;  // per region: added, negative if removed
};

// Both must be closed 2-manifolds over the same points; `points` is their number. O(points +
// triangles) for bounded degrees.
ChangedRegions changed_regions(const std::vector<Triangle>& before,
                               const std::vector<Triangle>& after, std::size_t points);

}  // namespace arris
