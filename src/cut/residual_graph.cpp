#include "cut/residual_graph.h"

#include "base/failure.h"

namespace arris {
namespace {

[[noreturn]] void refuse(const char* what) {
  throw Failure(ErrorCode::internal, what, "please report it with the input");
}

unsigned slot_of(const std::array<std::uint32_t, 4>& neighbours, std::uint32_t n) {
  for (unsigned i = 0; i < 4; ++i)
    if (neighbours[i] == n) return i;
  refuse("an arc of the flow graph has no sister");
}

unsigned packed_sisters(const FlowGraph& graph, std::uint32_t n) {
  unsigned packed = 0;
  for (unsigned i = 0; i < 4; ++i) {
    const std::uint32_t u = graph.neighbours[n][i];
    if (u == no_node) continue;
    if (u >= graph.neighbours.size()) refuse("an arc of the flow graph leads nowhere");
    if (graph.capacity[n][i] < 0 || graph.capacity[n][i] > max_arc_capacity)
      refuse("a capacity of the flow graph is out of range");
    packed |= slot_of(graph.neighbours[u], n) << (2 * i);
  }
  return packed;
}

}  // namespace

#ifdef FLOW_SOA
ResidualGraph::ResidualGraph(FlowGraph graph)
    : neighbours_(std::move(graph.neighbours)), residual_(std::move(graph.capacity)), excess_(std::move(graph.terminal)) {
  sisters_.resize(size()); label_.resize(size()); next_.resize(size(), no_node); parent_.resize(size());
  graph.neighbours = neighbours_;
  graph.capacity = residual_;
  for (std::uint32_t n = 0; n < size(); ++n) {
    sisters_[n] = static_cast<std::uint8_t>(packed_sisters(graph, n));
    for (unsigned i = 0; i < 4; ++i)
      if (neighbours_[n][i] == no_node) { neighbours_[n][i] = n; residual_[n][i] = 0; sisters_[n] |= static_cast<std::uint8_t>(i << (2 * i)); }
  }
}
#else
ResidualGraph::ResidualGraph(FlowGraph graph) {
  nodes_.resize(graph.neighbours.size());
  for (std::uint32_t n = 0; n < size(); ++n) {
    Node& node = nodes_[n];
    node.neighbour = graph.neighbours[n];
    node.residual = graph.capacity[n];
    node.excess = graph.terminal[n];
    node.sisters = static_cast<std::uint8_t>(packed_sisters(graph, n));
    for (unsigned i = 0; i < 4; ++i)
      if (node.neighbour[i] == no_node) { node.neighbour[i] = n; node.residual[i] = 0; node.sisters |= static_cast<std::uint8_t>(i << (2 * i)); }
  }
}
#endif

}  // namespace arris
