// The boundary of the labels as swaps see it: which flips keep it a 2-manifold of the same
// topology.
#pragma once

#include <vector>

#include "tetra/edge_walk.h"
#include "tetra/tet_mesh.h"

namespace arris {

class Boundary {
 public:
  // Holds on to both. Complexity: O(size of the mesh).
  Boundary(const TetMesh& mesh, Labels& labels);

  const TetMesh& mesh() const noexcept { return mesh_; }
  const Labels& labels() const noexcept { return labels_; }

  // Bit i is set if facet i of t is on the boundary.
  unsigned facets(Tet t) const noexcept {
    unsigned mask = 0;
    for (std::size_t i = 0; i < 4; ++i)
      mask |= static_cast<unsigned>(labels_[mesh_.neighbours[t][i]] != labels_[t]) << i;
    return mask;
  }

  // The vertex has a boundary facet.
  bool on_surface(Index v) const noexcept { return degree_[v] > 0; }

  // The flip of finite t keeps the boundary a 2-manifold with the same topology. That is so if what
  // t shares with the boundary is one disc: a facet without the vertex opposite, two facets without
  // the edge opposite, or three facets.
  bool is_simple(Tet t) const;

  // The vertex that a simple flip of t takes off the surface, or no_index.
  Index removed_vertex(Tet t) const noexcept;

  // Gives finite t the other label.
  void flip(Tet t);

 private:
  bool edge_on_surface(Tet t, int p, int q) const;

  const TetMesh& mesh_;
  Labels& labels_;
  std::vector<std::uint32_t> degree_;  // boundary facets round each vertex
};

}  // namespace arris
