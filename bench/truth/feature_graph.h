// The sharp edges and corners of a mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "arris/types.h"

namespace arris::truth {

struct SharpEdge {
  Index a = no_index, b = no_index;  // a < b
  Vec3 normal;                       // unit: the mean of the triangles at the edge
};

// The sharp edges, and for every vertex those that end in it.
struct FeatureGraph {
  std::vector<SharpEdge> sharp;              // sorted by (a, b)
  std::vector<std::vector<std::size_t>> at;  // per vertex: indices into `sharp`
  std::vector<bool> corner;  // an end of chains: not passed straight through by two sharp edges

  Index other_end(std::size_t e, Index v) const {
    return sharp[e].a == v ? sharp[e].b : sharp[e].a;
  }
};

// An edge is sharp if its two triangles turn by more than `angle` (radians), or if it has not two.
// A vertex is a corner if sharp edges end, meet or turn by more than the angle there. O(n log n).
FeatureGraph feature_graph(const Mesh& mesh, double angle);

}  // namespace arris::truth
