// Blue noise by removing the most crowded of many points.
#pragma once

#include <cstddef>
#include <vector>

#include "arris/types.h"

namespace arris::truth {

// The indices, ascending, of the points that stay when the most crowded are removed one by one
// until `n` are left (Yuksel, Sample elimination for generating Poisson disk sample sets, 2015);
// the first `kept` are never removed. Points i and j crowd each other if they are nearer than
// `spacing` times the mean of scale[i] and scale[j]; an empty `scale` means 1 for all. Distances
// are straight, not along the surface. O(m log m) for m points of about five times the density.
std::vector<std::size_t> eliminate(const std::vector<Vec3>& points,
                                   const std::vector<double>& scale, std::size_t kept,
                                   std::size_t n, double spacing);

}  // namespace arris::truth
