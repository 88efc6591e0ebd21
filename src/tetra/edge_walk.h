// Walking round an edge of the mesh, from tetrahedron to tetrahedron.
#pragma once

#include "tetra/tet_mesh.h"

namespace arris {

// One stop of a walk round an edge: a tetrahedron that has the edge, and its two facets that do.
// The walk came in through facet `in` and leaves through facet `out`; the edge is the other two
// corners.
struct EdgeStep {
  Tet t = no_tet;
  int in = 0, out = 0;
};

inline int corner_of(const TetMesh& mesh, Tet t, Index v) noexcept {
  const auto& c = mesh.vertices[t];
  return c[0] == v ? 0 : c[1] == v ? 1 : c[2] == v ? 2 : 3;
}

// The next stop. Infinite tetrahedra are stops like any other, so every walk comes round.
inline EdgeStep next_round_edge(const TetMesh& mesh, EdgeStep s) noexcept {
  const Tet n = mesh.neighbours[s.t][static_cast<std::size_t>(s.out)];
  return {n, mesh.facet_to(n, s.t),
          corner_of(mesh, n, mesh.vertices[s.t][static_cast<std::size_t>(s.in)])};
}

// The last stop with the label of s.t: its facet `out` is on the boundary of the labels. There must
// be such a facet round the edge.
inline EdgeStep last_of_label(const TetMesh& mesh, const Labels& labels, EdgeStep s) noexcept {
  const std::uint8_t label = labels[s.t];
  while (labels[mesh.neighbours[s.t][static_cast<std::size_t>(s.out)]] == label)
    s = next_round_edge(mesh, s);
  return s;
}

}  // namespace arris
