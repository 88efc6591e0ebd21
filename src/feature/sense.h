// Senses the smooth surfaces that meet at each sample: patches grown over the facets of a first
// surface, each on one side of a feature, then settled between neighbours.
#pragma once

#include <span>
#include <vector>

#include "base/job.h"
#include "feature/facets.h"
#include "feature/local_surface.h"

namespace arris {

// Surfaces of point v: surface[first[v] .. first[v+1]). None: not on the surface, nothing smooth
// was found, or the surface is so flat round it that no feature can be near; one: a smooth point;
// two or more: the point lies on a feature.
struct Sensed {
  std::vector<LocalSurface> surface;
  std::vector<Index> first;

  std::span<const LocalSurface> at(Index v) const noexcept {
    return {surface.data() + first[v], surface.data() + first[v + 1]};
  }
};

// The points near which the surface bends enough for a feature to be there: 1, others 0.
std::vector<std::uint8_t> near_bends(const FacetMesh& mesh, std::size_t points);

// `spacing`: sample spacing h > 0 per point; `wanted`: 0 for points to leave out; `known`: the
// surfaces at the last points, feature points, which keep them;
// `roughness`: a length by which samples lie off the surface, 0 for clean ones. O(points), in
// parallel; the result does not depend on the number of threads.
Sensed sense_surfaces(const std::vector<Vec3>& points, const FacetMesh& mesh,
                      const std::vector<double>& spacing, const std::vector<std::uint8_t>& wanted,
                      const std::vector<std::vector<LocalSurface>>& known, double roughness,
                      Job& job);

}  // namespace arris
