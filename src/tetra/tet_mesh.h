// The tetrahedral mesh in flat arrays, and its dual graph, which is the same arrays read as a
// graph: one node a tetrahedron, four arcs each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "arris/types.h"

namespace arris {

using Tet = std::uint32_t;  // index of a tetrahedron: the one place to widen it
inline constexpr Tet no_tet = 0xFFFFFFFFu;
// Facets are numbered 4 t + i in 32 bits too: about 150 million points near a surface.
inline constexpr std::size_t most_tets = 0x38000000u;

// The vertex at infinity, that closes the hull: a facet of the hull is shared with an infinite
// tetrahedron whose fourth vertex this is.
inline constexpr Index infinite_vertex = 0xFFFFFFFEu;

// Vertices of facet i (opposite vertex i) of a positively oriented tetrahedron, in the order that
// is counter-clockwise seen from outside the tetrahedron.
inline constexpr std::array<std::array<int, 3>, 4> facet_corners = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
// The six edges as pairs of corners; edge e is opposite edge 5 - e.
inline constexpr std::array<std::array<int, 2>, 6> edge_corners = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

// A closed triangulation of the whole of space. Finite tetrahedra come first (0 .. finite-1) and
// are positively oriented (orient3d > 0); infinite ones follow, each with infinite_vertex once.
// neighbours[t][i] is across the facet opposite vertices[t][i]; it is never no_tet.
struct TetMesh {
  std::vector<Vec3> points;                    // samples first, then added points
  std::size_t samples = 0;                     // points[0 .. samples) are samples
  std::vector<std::array<Index, 4>> vertices;  // per tetrahedron
  std::vector<std::array<Tet, 4>> neighbours;  // per tetrahedron
  std::size_t finite = 0;

  // The sample nearest to each point; empty if every point is a sample.
  std::vector<Index> nearest;
  Index nearest_sample(Index v) const noexcept { return nearest.empty() ? v : nearest[v]; }
  bool is_sample(Index v) const noexcept { return v < samples; }

  std::size_t size() const noexcept { return vertices.size(); }
  bool is_finite(Tet t) const noexcept { return t < finite; }
  // Which facet of `t` is shared with `neighbour`: the i with neighbours[t][i] == neighbour.
  int facet_to(Tet t, Tet neighbour) const noexcept {
    const auto& n = neighbours[t];
    return n[0] == neighbour ? 0 : n[1] == neighbour ? 1 : n[2] == neighbour ? 2 : 3;
  }
};

// For every vertex one tetrahedron that has it (finite if there is one): the way into its star.
std::vector<Tet> star_seeds(const TetMesh& mesh);

// Inside (1) or outside (0) per tetrahedron; infinite tetrahedra are outside.
using Labels = std::vector<std::uint8_t>;

}  // namespace arris
