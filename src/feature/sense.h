// Senses the smooth surfaces that meet at each sample: patches grown over the facets of a first
// surface, each from one side of a feature only.
#pragma once

#include <vector>

#include "base/job.h"
#include "feature/facets.h"
#include "feature/local_surface.h"

namespace arris {

// Surfaces of point v: surface[first[v] .. first[v+1]). None: not on the surface, or nothing smooth
// was found there; one: a smooth point; two or more: the point lies on a feature.
struct Sensed {
  std::vector<LocalSurface> surface;
  std::vector<Index> first;

  std::span<const LocalSurface> at(Index v) const noexcept {
    return {surface.data() + first[v], surface.data() + first[v + 1]};
  }
};

// `spacing`: sample spacing h > 0 per point. O(points), in parallel.
Sensed sense_surfaces(const std::vector<Vec3>& points, const FacetMesh& mesh,
                      const std::vector<double>& spacing, Job& job);

}  // namespace arris
