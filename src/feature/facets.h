// A closed triangle surface over a point array, with the neighbourhoods that sensing walks along.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "arris/types.h"

namespace arris {

// Flat arrays: facets, the facet across each side, and the facets round each point.
struct FacetMesh {
  std::vector<Triangle> facets;                  // indices of points, outward
  std::vector<std::array<Index, 3>> neighbours;  // [f][i]: across the side opposite corner i
  std::vector<Index> first, around;              // facets at point v: around[first[v]..first[v+1])

  // Facets over `points` points. O(facets log facets). Every side must be shared by exactly two
  // facets, in opposite directions; throws Failure(internal) otherwise.
  FacetMesh(std::vector<Triangle> triangles, std::size_t points);

  std::span<const Index> star(Index v) const noexcept {
    return {around.data() + first[v], around.data() + first[v + 1]};
  }
};

// Index of the corner of facet `f` that is not an end of its side with `other`.
int corner_opposite(const FacetMesh& mesh, Index f, Index other) noexcept;

}  // namespace arris
