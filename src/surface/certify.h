// The certificate as a step of a larger job; check() in check.cpp is its public face.
#pragma once

#include <cstddef>

#include "arris/check.h"
#include "arris/types.h"
#include "base/job.h"

namespace arris {

// Examines `mesh` within the current stage of `job`, which it ticks from 0 to 1. If a corner names
// no vertex or a coordinate is not finite, only topology is examined; if the mesh is not closed,
// manifold, consistently walked and free of intersections, inside and outside mean nothing and
// inward_components stays 0. Degenerate triangles take part in topology (unless a corner is
// repeated: such a triangle has no edges) but not in the search for intersections.
// The volume of a mesh without defects is never rounded to zero or below, and volume and area never
// to infinity, so that their sign can be trusted at any scale.
// Throws Failure: cancelled, out_of_memory.
// Complexity: O(n log n + k) for n triangles and k pairs of them with overlapping boxes.
Certificate certify(const Mesh& mesh, Job& job);

// Bytes that certify needs at most, beside the mesh itself.
std::size_t forecast_certify_memory(std::size_t vertices, std::size_t triangles);

}  // namespace arris
