#include "cut/residual_graph.h"

#include <algorithm>
#include <utility>

#include "base/failure.h"

namespace arris {
namespace {

[[noreturn]] void refuse(const char* what) {
  throw Failure(ErrorCode::internal, what, "please report it with the input");
}

unsigned slot_of(const std::array<std::uint32_t, 4>& neighbours, std::uint32_t n) {
  const auto slot = std::find(neighbours.begin(), neighbours.end(), n);
  if (slot == neighbours.end()) refuse("an arc of the flow graph has no sister");
  return static_cast<unsigned>(slot - neighbours.begin());
}

}  // namespace

ResidualGraph::ResidualGraph(FlowGraph graph)
    : neighbours_(std::move(graph.neighbours)),
      residual_(std::move(graph.capacity)),
      excess_(std::move(graph.terminal)),
      sisters_(excess_.size(), 0) {
  if (neighbours_.size() != size() || residual_.size() != size())
    refuse("the arrays of the flow graph differ in size");
  for (std::uint32_t n = 0; n < size(); ++n) {
    unsigned packed = 0;
    for (unsigned i = 0; i < 4; ++i) {
      std::uint32_t& u = neighbours_[n][i];
      if (u == no_node) {
        u = n;
        residual_[n][i] = 0;
        packed |= i << (2 * i);
        continue;
      }
      if (u >= size() || u == n) refuse("an arc of the flow graph leads nowhere");
      if (residual_[n][i] < 0 || residual_[n][i] > max_arc_capacity)
        refuse("a capacity of the flow graph is out of range");
      packed |= slot_of(neighbours_[u], n) << (2 * i);
    }
    sisters_[n] = static_cast<std::uint8_t>(packed);
  }
}

std::int64_t ResidualGraph::total_excess() const noexcept {
  std::int64_t sum = 0;
  for (const std::int64_t e : excess_) sum += std::max<std::int64_t>(e, 0);
  return sum;
}

std::int64_t push_between_neighbours(ResidualGraph& graph) {
  std::int64_t flow = 0;
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    for (unsigned i = 0; i < 4 && graph.excess(v) > 0; ++i) {
      const std::uint32_t u = graph.neighbour(v, i);
      const std::int64_t amount =
          std::min({graph.excess(v), -graph.excess(u), std::int64_t{graph.residual(v, i)}});
      if (amount <= 0) continue;
      graph.push(v, i, static_cast<std::int32_t>(amount));
      graph.add_excess(v, -amount);
      graph.add_excess(u, amount);
      flow += amount;
    }
  }
  return flow;
}

}  // namespace arris
