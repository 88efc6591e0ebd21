// The combinatorial half of the certificate: what indices alone say about a mesh.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "arris/types.h"
#include "base/job.h"
#include "surface/defects.h"

namespace arris {

// A triangle is proper if its corners name three different vertices. Others have no edges: they are
// counted and then left out of everything below.
struct MeshTopology {
  // Triangles round vertex v, ascending: star[star_begin[v] .. star_begin[v + 1]).
  std::vector<std::size_t> star_begin;
  std::vector<Index> star;
  // Per triangle and side k (corner k to k + 1): the next triangle in the cycle of all those that
  // share the edge; no_index at a boundary and for improper triangles.
  std::vector<std::array<Index, 3>> neighbours;
  // Per triangle: its component, numbered by lowest triangle; no_index if improper.
  std::vector<Index> component;
  std::size_t components = 0;

  std::uint64_t edges = 0;
  std::int64_t euler = 0;         // V - E + F of the proper triangles and their vertices
  Defects invalid_corners;        // {triangle, named vertex}
  Defects repeated_corners;       // {triangle}
  Defects unreferenced_vertices;  // {vertex}: named by no triangle at all
  Defects boundary_edges;         // {vertex, vertex}
  Defects nonmanifold_edges;      // {vertex, vertex, triangles round it}
  Defects misoriented_edges;      // {vertex, vertex}: two triangles, both walk it the same way
  Defects nonmanifold_vertices;   // {vertex, fans round it}

  std::span<const Index> star_of(Index v) const {
    return {star.data() + star_begin[v], star_begin[v + 1] - star_begin[v]};
  }
  bool is_closed_manifold() const noexcept {
    return boundary_edges.count == 0 && nonmanifold_edges.count == 0 &&
           misoriented_edges.count == 0 && nonmanifold_vertices.count == 0;
  }
};

// Throws Failure(cancelled). Complexity: O(n log d) for n triangles, d the highest vertex degree.
MeshTopology build_topology(std::size_t vertices, std::span<const Triangle> triangles, Job& job);

}  // namespace arris
