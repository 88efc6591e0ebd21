#include "swap/boundary.h"

#include <bit>

namespace arris {

Boundary::Boundary(const TetMesh& mesh, Labels& labels)
    : mesh_(mesh), labels_(labels), degree_(mesh.points.size(), 0) {
  for (Tet t = 0; t < mesh.finite; ++t) {
    if (labels[t] == 0) continue;  // so that each facet counts once
    const unsigned mask = facets(t);
    for (std::size_t i = 0; i < 4; ++i)
      if ((mask >> i & 1u) != 0)
        for (int corner : facet_corners[i])
          ++degree_[mesh.vertices[t][static_cast<std::size_t>(corner)]];
  }
}

// All tetrahedra round an edge of the surface cannot have the same label.
bool Boundary::edge_on_surface(Tet t, int p, int q) const {
  int in = 0;
  while (in == p || in == q) ++in;
  const EdgeStep start{t, in, 6 - p - q - in};
  EdgeStep s = start;
  do {
    s = next_round_edge(mesh_, s);
    if (labels_[s.t] != labels_[t]) return true;
  } while (s.t != t);
  return false;
}

bool Boundary::is_simple(Tet t) const {
  const unsigned mask = facets(t);
  switch (std::popcount(mask)) {
    case 1:
      return !on_surface(mesh_.vertices[t][static_cast<std::size_t>(std::countr_zero(mask))]);
    case 2: {
      const int p = std::countr_zero(mask), q = static_cast<int>(std::bit_width(mask)) - 1;
      return !edge_on_surface(t, p, q);  // facet p is opposite corner p
    }
    case 3:
      return true;
    default:
      return false;
  }
}

Index Boundary::removed_vertex(Tet t) const noexcept {
  const unsigned mask = facets(t);
  if (std::popcount(mask) != 3) return no_index;
  return mesh_.vertices[t][static_cast<std::size_t>(std::countr_one(mask))];
}

void Boundary::flip(Tet t) {
  const unsigned mask = facets(t);
  labels_[t] ^= 1u;
  for (std::size_t i = 0; i < 4; ++i)
    for (int corner : facet_corners[i]) {
      std::uint32_t& degree = degree_[mesh_.vertices[t][static_cast<std::size_t>(corner)]];
      if ((mask >> i & 1u) != 0)
        --degree;
      else
        ++degree;
    }
}

}  // namespace arris
