// Maximum flow / minimum cut on a dual graph: at most four arcs a node, two terminals.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/job.h"

namespace arris {

inline constexpr std::uint32_t no_node = 0xFFFFFFFFu;

// The largest capacity of an arc: the residual of one holds at most the sum of it and its sister's,
// which must fit into 32 bits.
inline constexpr std::int32_t max_arc_capacity = (1 << 30) - 1;

// Capacities are integers, so that flow value and cut value can be compared for equality.
struct FlowGraph {
  // neighbours[n][i], or no_node; symmetric: each neighbour has n among its own, exactly once.
  std::vector<std::array<std::uint32_t, 4>> neighbours;
  // capacity[n][i] in [0, max_arc_capacity] of the arc n -> neighbours[n][i]; ignored where there
  // is no neighbour.
  std::vector<std::array<std::int32_t, 4>> capacity;
  // > 0: capacity of source -> n; < 0: minus the capacity of n -> sink. A node with both has their
  // difference here, and the smaller is a constant of the cut. Sums must fit into 63 bits.
  std::vector<std::int64_t> terminal;
};

struct MinCut {
  std::int64_t flow = 0;                  // = capacity of the cut
  std::vector<std::uint8_t> source_side;  // 1 for nodes reachable from the source in the residual
};

// Solves it. The source side returned is the smallest of all minimum cuts (the nodes reachable from
// the source in the residual graph), which is unique: the answer does not depend on the algorithm.
// Takes the graph by value because it becomes the residual graph. Throws Failure:
// cancelled, internal (not symmetric, or a capacity out of range).
MinCut max_flow(FlowGraph graph, Job& job);

// Capacity of the cut that `source_side` describes, terminals included, in the *original* graph.
std::int64_t cut_capacity(const FlowGraph& graph, const std::vector<std::uint8_t>& source_side);

}  // namespace arris
