// From a set of sharp edges to a network of lines: gaps closed, stubs and noise taken away.
#pragma once

#include <cstdint>
#include <vector>

#include "arris/types.h"
#include "feature/mesh_edges.h"

namespace arris {

// The chosen edges as a graph: 1 per edge of the network, and how many meet at each vertex.
class Network {
 public:
  Network(const Mesh& mesh, const MeshEdges& edges, std::vector<std::uint8_t> chosen);

  const MeshEdges& edges() const { return edges_; }
  bool has(Index e) const { return chosen_[e] != 0; }
  std::uint32_t degree(Index v) const { return degree_[v]; }
  void add(Index e);
  void remove(Index e);

  // The edge of the network at v that is not e, where the degree is 2; no_index at other degrees.
  Index next(Index v, Index e) const;
  // The angle in radians by which a line turns that comes in along edge `in` and leaves v along
  // edge `out`; 0 straight on.
  double bend(Index in, Index v, Index out) const;

 private:
  const Mesh& mesh_;
  const MeshEdges& edges_;
  std::vector<std::uint8_t> chosen_;
  std::vector<std::uint32_t> degree_;
};

// Goes on from every loose end along the edges that turn most, roughly straight on, and keeps these
// edges if they lead to the network again within a few steps. O(n).
void close_gaps(Network& network);

// Takes away loose ends and loose lines of a few edges. O(n).
void prune_stubs(Network& network);

}  // namespace arris
