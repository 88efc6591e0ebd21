// Which triangles meet at each point, in compressed rows.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arris/types.h"

namespace arris {

// Those of point v in increasing order. 32-bit numbers: the triangles of a surface over the points
// of a TetMesh have fewer corners than that. O(points + triangles).
class FacetStars {
 public:
  FacetStars() = default;
  FacetStars(std::size_t points, const std::vector<Triangle>& triangles);
  std::span<const Index> operator[](Index v) const noexcept {
    return {facets_.data() + start_[v], facets_.data() + start_[v + 1]};
  }

 private:
  std::vector<Index> start_;
  std::vector<Index> facets_;
};

}  // namespace arris
