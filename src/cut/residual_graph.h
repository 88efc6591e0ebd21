// The residual graph of a flow: at most four arcs a node, one cache line a node.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cut/max_flow.h"

namespace arris {

#ifdef FLOW_SOA
class ResidualGraph {
 public:
  explicit ResidualGraph(FlowGraph graph);
  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(excess_.size()); }
  std::uint32_t neighbour(std::uint32_t n, unsigned i) const noexcept { return neighbours_[n][i]; }
  unsigned sister(std::uint32_t n, unsigned i) const noexcept { return (sisters_[n] >> (2 * i)) & 3u; }
  std::int32_t& residual(std::uint32_t n, unsigned i) noexcept { return residual_[n][i]; }
  std::int64_t& excess(std::uint32_t n) noexcept { return excess_[n]; }
  std::int32_t& label(std::uint32_t n) noexcept { return label_[n]; }
  std::uint32_t& next(std::uint32_t n) noexcept { return next_[n]; }
  std::uint8_t& parent(std::uint32_t n) noexcept { return parent_[n]; }
 private:
  std::vector<std::array<std::uint32_t, 4>> neighbours_;
  std::vector<std::array<std::int32_t, 4>> residual_;
  std::vector<std::int64_t> excess_;
  std::vector<std::int32_t> label_;
  std::vector<std::uint32_t> next_;
  std::vector<std::uint8_t> sisters_, parent_;
};
#else
class ResidualGraph {
 public:
  explicit ResidualGraph(FlowGraph graph);
  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(nodes_.size()); }
  std::uint32_t neighbour(std::uint32_t n, unsigned i) const noexcept { return nodes_[n].neighbour[i]; }
  unsigned sister(std::uint32_t n, unsigned i) const noexcept { return (nodes_[n].sisters >> (2 * i)) & 3u; }
  std::int32_t& residual(std::uint32_t n, unsigned i) noexcept { return nodes_[n].residual[i]; }
  std::int64_t& excess(std::uint32_t n) noexcept { return nodes_[n].excess; }
  std::int32_t& label(std::uint32_t n) noexcept { return nodes_[n].label; }
  std::uint32_t& next(std::uint32_t n) noexcept { return nodes_[n].next; }
  std::uint8_t& parent(std::uint32_t n) noexcept { return nodes_[n].parent; }
 private:
  struct alignas(64) Node {
    std::array<std::uint32_t, 4> neighbour;
    std::array<std::int32_t, 4> residual;
    std::int64_t excess = 0;
    std::int32_t label = 0;
    std::uint32_t next = no_node;
    std::uint8_t sisters = 0;
    std::uint8_t parent = 0;
  };
  std::vector<Node> nodes_;
};
#endif

}  // namespace arris
