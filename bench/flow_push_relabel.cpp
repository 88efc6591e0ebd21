#include <algorithm>
#include <utility>

#include "cut/residual_graph.h"
#include "flow_algorithms.h"

namespace arris {
namespace {

// Everything here runs from the sink: what the sinks can take is pushed against the arcs towards
// what the sources can give. A label is a lower bound of the distance to a source with some left.
class PushRelabel {
 public:
  PushRelabel(FlowGraph graph, Job& job) : g_(std::move(graph)), job_(job), label_(g_.size(), 0) {}
  MinCut solve();

 private:
  void global_relabel();
  void activate(std::uint32_t v);
  void discharge(std::uint32_t v);
  bool push(std::uint32_t v, unsigned i);
  void relabel(std::uint32_t v);
  void close_gap(std::int32_t level);

  ResidualGraph g_;
  Job& job_;
  std::vector<std::int32_t> label_;
  std::int64_t flow_ = 0;
  std::int32_t unreachable_ = 0;
  std::size_t work_ = 0, highest_ = 0;
  std::vector<std::uint32_t> queue_;
  std::vector<std::vector<std::uint32_t>> active_;  // nodes with demand, by label
  std::vector<std::uint32_t> population_;           // nodes of each label
};

void PushRelabel::activate(std::uint32_t v) {
  const auto level = static_cast<std::size_t>(label_[v]);
  if (level >= active_.size()) active_.resize(level + 1);
  active_[level].push_back(v);
  highest_ = std::max(highest_, level);
}

// Breadth first from all nodes with supply left.
void PushRelabel::global_relabel() {
  unreachable_ = static_cast<std::int32_t>(g_.size()) + 2;
  queue_.clear();
  for (std::uint32_t n = 0; n < g_.size(); ++n) {
    label_[n] = g_.excess(n) > 0 ? 1 : unreachable_;
    if (g_.excess(n) > 0) queue_.push_back(n);
  }
  for (std::size_t k = 0; k < queue_.size(); ++k) {
    const std::uint32_t v = queue_[k];
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t u = g_.neighbour(v, i);
      if (label_[u] != unreachable_ || g_.residual(v, i) == 0) continue;
      label_[u] = label_[v] + 1;
      queue_.push_back(u);
    }
  }
  const std::size_t levels =
      queue_.empty() ? 2 : static_cast<std::size_t>(label_[queue_.back()]) + 2;
  population_.assign(levels, 0);
  for (const std::uint32_t n : queue_) ++population_[static_cast<std::size_t>(label_[n])];
  for (auto& level : active_) level.clear();
  highest_ = 0;
  for (const std::uint32_t n : queue_)
    if (g_.excess(n) < 0) activate(n);
  work_ = 0;
}

// Pushes what v demands to neighbour i; true if that is all.
bool PushRelabel::push(std::uint32_t v, unsigned i) {
  const std::uint32_t u = g_.neighbour(v, i);
  const std::int64_t amount = std::min<std::int64_t>(-g_.excess(v), g_.residual_into(v, i));
  g_.push(u, g_.sister(v, i), static_cast<std::int32_t>(amount));
  const std::int64_t before = g_.excess(u);
  g_.add_excess(u, -amount);
  g_.add_excess(v, amount);
  flow_ += std::min(std::max<std::int64_t>(before, 0), amount);
  if (before >= 0 && g_.excess(u) < 0) activate(u);
  return g_.excess(v) == 0;
}

void PushRelabel::close_gap(std::int32_t level) {
  // Every node above the gap is cut off from the supply. Only active ones matter now; the others
  // are found by the next global relabelling.
  for (std::size_t l = static_cast<std::size_t>(level); l < active_.size(); ++l) {
    for (const std::uint32_t n : active_[l])
      if (label_[n] == static_cast<std::int32_t>(l)) label_[n] = unreachable_;
    active_[l].clear();
  }
}

void PushRelabel::relabel(std::uint32_t v) {
  const std::int32_t old = label_[v];
  std::int32_t least = unreachable_ - 1;
  for (unsigned i = 0; i < 4; ++i)
    if (g_.residual_into(v, i) > 0) least = std::min(least, label_[g_.neighbour(v, i)]);
  label_[v] = least + 1;
  work_ += 1;
  const bool gap = --population_[static_cast<std::size_t>(old)] == 0;
  if (gap) {
    label_[v] = unreachable_;
    close_gap(old + 1);
  } else if (label_[v] < unreachable_) {
    if (static_cast<std::size_t>(label_[v]) >= population_.size())
      population_.resize(static_cast<std::size_t>(label_[v]) + 1, 0);
    ++population_[static_cast<std::size_t>(label_[v])];
  }
}

void PushRelabel::discharge(std::uint32_t v) {
  while (label_[v] < unreachable_) {
    for (unsigned i = 0; i < 4; ++i)
      if (g_.residual_into(v, i) > 0 && label_[g_.neighbour(v, i)] + 1 == label_[v] && push(v, i))
        return;
    relabel(v);
  }
}

MinCut PushRelabel::solve() {
  constexpr double relabels_between_global = 0.5;  // per node
  const auto patience =
      static_cast<std::size_t>(relabels_between_global * static_cast<double>(g_.size())) + 1;
  while (true) {
    global_relabel();
    bool any = false;
    std::size_t steps = 0;
    while (work_ < patience) {
      while (highest_ > 0 && active_[highest_].empty()) --highest_;
      if (highest_ == 0) break;
      const std::uint32_t v = active_[highest_].back();
      active_[highest_].pop_back();
      any = true;
      if (label_[v] == static_cast<std::int32_t>(highest_) && g_.excess(v) < 0) discharge(v);
      if (++steps % 4096 == 0) job_.tick(0);
    }
    if (!any) break;
  }
  MinCut cut;
  cut.flow = flow_;
  cut.source_side.resize(g_.size());
  for (std::uint32_t n = 0; n < g_.size(); ++n) cut.source_side[n] = label_[n] != unreachable_;
  return cut;
}

}  // namespace

MinCut push_relabel(FlowGraph graph, Job& job) {
  return PushRelabel(std::move(graph), job).solve();
}

}  // namespace arris
