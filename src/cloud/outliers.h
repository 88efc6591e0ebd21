// Points that belong to no surface, from positions alone: stray ones and clumps.
#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "cloud/prepare.h"

namespace arris {

// One per point: 1 for an outlier. `points` are distinct and finite.
//
// Clumps that are spread less evenly than the surface go first, whether they touch it or not.
// A stray point lies in far thinner company than its neighbours keep (Breunig, Kriegel, Ng, Sander,
// "LOF: identifying density-based local outliers", 2000), and off the surface that they sample. Far
// from the surface its neighbours are strays too, so they are peeled off layer by layer, beginning
// at the surface. What is left falls into groups; a group much smaller than the largest is a clump
// if it has too few points for a solid, is spread less evenly, or fills space instead of a surface.
//
// A surface of varying density, with tips, edges, holes or noise keeps all its points; so does any
// small part of it that is sampled as a surface is.
// Complexity: O(n log n), 80 bytes a point; the same result for every number of threads.
std::vector<std::uint8_t> find_outliers(const std::vector<Vec3>& points, Job& job);

// Removes the marked samples; returns how many.
std::uint64_t drop_samples(Samples& samples, const std::vector<std::uint8_t>& drop);

}  // namespace arris
