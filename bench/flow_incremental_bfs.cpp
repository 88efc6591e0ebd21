#include <algorithm>
#include <limits>
#include <utility>

#include "cut/residual_graph.h"
#include "flow_algorithms.h"

namespace arris {
namespace {

// What a node hangs from: one of its four arcs, a terminal, or nothing.
constexpr std::uint8_t at_terminal = 4, no_parent = 5;

// Orphans by distance: chains through IncrementalBfs::next_. Those of a level are handled before
// any above.
struct OrphanBuckets {
  std::vector<std::uint32_t> head;
  std::size_t lowest = 0, count = 0;
};

class IncrementalBfs {
 public:
  IncrementalBfs(FlowGraph graph, Job& job)
      : g_(std::move(graph)),
        job_(job),
        label_(g_.size(), 0),
        next_(g_.size(), no_node),
        parent_(g_.size(), no_parent) {}
  MinCut solve();

 private:
  template <int Side>
  static constexpr std::size_t index() {
    return Side > 0 ? 0 : 1;
  }
  // What the arc between v and its neighbour i can carry: away from the root, and towards v.
  template <int Side>
  std::int32_t outward(std::uint32_t v, unsigned i) {
    return Side > 0 ? g_.residual(v, i) : g_.residual_into(v, i);
  }
  template <int Side>
  std::int32_t inward(std::uint32_t v, unsigned i) {
    return outward<-Side>(v, i);
  }
  template <int Side>
  void grow();
  template <int Side>
  void scan(std::uint32_t v);
  template <int Side>
  void adopt();
  template <int Side>
  void adopt(std::uint32_t v);
  template <int Side>
  void orphan(std::uint32_t v);
  template <int Side>
  std::int64_t path_capacity(std::uint32_t v);
  template <int Side>
  void push_path(std::uint32_t v, std::int32_t amount);
  void augment(std::uint32_t v, unsigned i);
  void plant();

  ResidualGraph g_;
  Job& job_;
  std::vector<std::int32_t> label_;  // Side x distance to the root; 0: free
  std::vector<std::uint32_t> next_;  // in the bucket of orphans
  std::vector<std::uint8_t> parent_;
  std::int64_t flow_ = 0;
  // Per forest, the source's first: levels that are complete, and the highest label an orphan may
  // take, which is one more while the forest grows.
  std::array<std::int32_t, 2> depth_ = {1, 1}, limit_ = {1, 1};
  std::array<std::vector<std::uint32_t>, 2> frontier_, next_frontier_;
  std::array<OrphanBuckets, 2> orphans_;
};

void IncrementalBfs::plant() {
  flow_ = push_between_neighbours(g_);
  for (std::uint32_t n = 0; n < g_.size(); ++n) {
    const std::int64_t e = g_.excess(n);
    label_[n] = e > 0 ? 1 : e < 0 ? -1 : 0;
    parent_[n] = e ? at_terminal : no_parent;
    if (e) frontier_[e > 0 ? 0 : 1].push_back(n);
  }
}

template <int Side>
void IncrementalBfs::orphan(std::uint32_t v) {
  auto& o = orphans_[index<Side>()];
  const auto level = static_cast<std::size_t>(Side * label_[v]);
  if (level >= o.head.size()) o.head.resize(level + 1, no_node);
  parent_[v] = no_parent;
  next_[v] = o.head[level];
  o.head[level] = v;
  if (o.count == 0 || level < o.lowest) o.lowest = level;
  ++o.count;
}

template <int Side>
std::int64_t IncrementalBfs::path_capacity(std::uint32_t v) {
  std::int32_t least = std::numeric_limits<std::int32_t>::max();
  while (parent_[v] != at_terminal) {
    const unsigned i = parent_[v];
    least = std::min(least, inward<Side>(v, i));
    v = g_.neighbour(v, i);
  }
  return std::min<std::int64_t>(least, Side * g_.excess(v));
}

template <int Side>
void IncrementalBfs::push_path(std::uint32_t v, std::int32_t amount) {
  while (parent_[v] != at_terminal) {
    const unsigned i = parent_[v];
    const std::uint32_t u = g_.neighbour(v, i);
    Side > 0 ? g_.push(u, g_.sister(v, i), amount) : g_.push(v, i, amount);
    if (inward<Side>(v, i) == 0) orphan<Side>(v);
    v = u;
  }
  g_.add_excess(v, -Side * std::int64_t{amount});
  if (g_.excess(v) == 0) orphan<Side>(v);
}

void IncrementalBfs::augment(std::uint32_t v, unsigned i) {
  const std::uint32_t u = g_.neighbour(v, i);
  const auto amount = static_cast<std::int32_t>(
      std::min({std::int64_t{g_.residual(v, i)}, path_capacity<1>(v), path_capacity<-1>(u)}));
  g_.push(v, i, amount);
  flow_ += amount;
  push_path<1>(v, amount);
  push_path<-1>(u, amount);
  adopt<1>();
  adopt<-1>();
}

// Hangs v from a node one level below; else raises it to the lowest level that some neighbour
// allows and lets it try again there, or sets it free if that is above the limit.
template <int Side>
void IncrementalBfs::adopt(std::uint32_t v) {
  const std::int32_t level = Side * label_[v];
  std::int32_t least = limit_[index<Side>()];
  for (unsigned i = 0; i < 4; ++i) {
    const std::int32_t l = Side * label_[g_.neighbour(v, i)];
    if (l <= 0 || l >= least || inward<Side>(v, i) == 0) continue;
    if (l + 1 == level) {
      parent_[v] = static_cast<std::uint8_t>(i);
      return;
    }
    least = l;
  }
  for (unsigned i = 0; i < 4; ++i) {
    const std::uint32_t u = g_.neighbour(v, i);
    if (Side * label_[u] > 0 && parent_[u] == g_.sister(v, i) && u != v) orphan<Side>(u);
  }
  if (least >= limit_[index<Side>()]) {
    label_[v] = 0;
    return;
  }
  label_[v] = Side * (least + 1);
  if (least + 1 == depth_[index<Side>()]) frontier_[index<Side>()].push_back(v);
  if (least + 1 > depth_[index<Side>()]) next_frontier_[index<Side>()].push_back(v);
  orphan<Side>(v);
}

template <int Side>
void IncrementalBfs::adopt() {
  auto& o = orphans_[index<Side>()];
  for (std::size_t level = o.lowest; o.count > 0; ++level) {
    while (o.head[level] != no_node) {
      const std::uint32_t v = o.head[level];
      o.head[level] = next_[v];
      --o.count;
      adopt<Side>(v);  // new orphans only at higher levels
    }
  }
}

template <int Side>
void IncrementalBfs::scan(std::uint32_t v) {
  const std::int32_t label = Side * depth_[index<Side>()];
  for (unsigned i = 0; i < 4;) {
    const std::uint32_t u = g_.neighbour(v, i);
    const std::int32_t l = Side * label_[u];
    if (l > 0 || outward<Side>(v, i) == 0) {
      ++i;
    } else if (l == 0) {
      label_[u] = label + Side;
      parent_[u] = static_cast<std::uint8_t>(g_.sister(v, i));
      next_frontier_[index<Side>()].push_back(u);
      ++i;
    } else {
      Side > 0 ? augment(v, i) : augment(u, g_.sister(v, i));
      if (label_[v] != label) return;
    }
  }
}

template <int Side>
void IncrementalBfs::grow() {
  constexpr std::size_t s = index<Side>();
  limit_[s] = depth_[s] + 1;
  for (std::size_t k = 0; k < frontier_[s].size(); ++k) {
    if (k % 4096 == 0) job_.tick(0);
    const std::uint32_t v = frontier_[s][k];
    if (label_[v] == Side * depth_[s]) scan<Side>(v);
  }
  frontier_[s].clear();
  frontier_[s].swap(next_frontier_[s]);
  ++depth_[s];
}

MinCut IncrementalBfs::solve() {
  plant();
  while (!frontier_[0].empty()) {
    if (!frontier_[1].empty() && depth_[1] < depth_[0])
      grow<-1>();
    else
      grow<1>();
  }
  MinCut cut;
  cut.flow = flow_;
  cut.source_side.resize(g_.size());
  for (std::uint32_t n = 0; n < g_.size(); ++n) cut.source_side[n] = label_[n] > 0;
  return cut;
}

}  // namespace

MinCut incremental_bfs(FlowGraph graph, Job& job) {
  return IncrementalBfs(std::move(graph), job).solve();
}

}  // namespace arris
