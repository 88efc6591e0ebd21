#include "tetra/facet_stars.h"

namespace arris {

FacetStars::FacetStars(std::size_t points, const std::vector<Triangle>& triangles)
    : start_(points + 1, 0) {
  for (const Triangle& t : triangles)
    for (Index v : t) ++start_[v + 1];
  for (std::size_t v = 0; v < points; ++v) start_[v + 1] += start_[v];
  facets_.resize(start_[points]);
  std::vector<Index> next(start_.begin(), start_.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (Index v : triangles[t]) facets_[next[v]++] = static_cast<Index>(t);
}

}  // namespace arris
