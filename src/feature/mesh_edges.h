// The edges of a triangle mesh, how sharply the surface turns at each, and who meets whom.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "arris/types.h"
#include "base/job.h"

namespace arris {

// An edge and its triangles. `turning` is the angle in radians between the normals, 0 where flat:
// positive at a ridge, negative in a groove, pi where the surface folds back. An edge with three or
// more triangles turns by pi; one with a single triangle by 0.
struct MeshEdge {
  std::array<Index, 2> ends;   // ascending
  std::array<Index, 2> faces;  // ascending; the second is no_index at a boundary
  double turning = 0;
  double length = 0;
  double dual = 0;  // distance of the circumcentres of the two triangles along the surface, >= 0
};

struct MeshEdges {
  std::vector<MeshEdge> edges;                // ascending by ends
  std::vector<std::array<Index, 3>> of_face;  // per triangle: edge of corner k and k + 1
  std::vector<std::size_t> star_begin;        // edges at vertex v, ascending:
  std::vector<Index> star;                    // star[star_begin[v] .. star_begin[v + 1])

  std::span<const Index> at(Index v) const {
    return {star.data() + star_begin[v], star_begin[v + 1] - star_begin[v]};
  }
  Index other_end(Index e, Index v) const {
    return edges[e].ends[0] == v ? edges[e].ends[1] : edges[e].ends[0];
  }
};

// Unit normals, null for a triangle without area. A needle, whose own plane is an accident of
// rounding, takes that of the triangle across its longest edge.
std::vector<Vec3> stable_normals(const Mesh& mesh, const MeshEdges& edges);

// Corners must be valid and coordinates finite. Triangles with a repeated corner have edges only
// between different corners. O(n log n).
MeshEdges collect_edges(const Mesh& mesh, Job& job);

}  // namespace arris
