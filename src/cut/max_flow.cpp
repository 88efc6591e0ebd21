// Boykov & Kolmogorov, "An experimental comparison of min-cut/max-flow algorithms for energy
// minimization in vision", PAMI 2004, on a graph of at most four arcs a node: a child is a
// neighbour whose parent slot points back, so trees need no lists. Two additions: paths of one arc
// are filled in a sweep beforehand, and arcs are taken again until nothing passes.
//
// Chosen by measurement (bench/max_flow_bench.cpp) on dual graphs of Delaunay tetrahedra of sampled
// surfaces, clean, noisy or with outliers, and terminals hard, sparse or soft. Processor time as a
// multiple of this one's, geometric mean (and range) where it is long enough to measure:
//   incremental breadth-first search (Goldberg et al., ESA 2011)   1.7 at 100k samples (1.3 - 2.3),
//                                                                  1.3 - 1.6 at 1M, 0.6 - 1.9 at
//                                                                  10k
//   push-relabel, highest label (Cherkassky & Goldberg, 1997)      3.6 at 10k samples (1.2 - 20);
//                                                                  one variant, little tuned, and
//                                                                  without the sweep
// The sweep beforehand saves about a third where terminals are everywhere; elsewhere its cost does
// not show.
// Ten times the nodes took eleven times as long; the worst case is O(n^2 m C).
//
// No warm start: solving again after all capacities changed, as the iteration of the paper has it,
// takes 0.8 - 1.0 of the time when it starts from the last residual graph (Kohli & Torr, PAMI
// 2007), since the flow to be repaired is everywhere; only changes to a tenth of the arcs or fewer
// would gain (0.4 - 0.7). Too little for keeping the residual graph in memory between cuts.
#include "cut/max_flow.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "cut/residual_graph.h"

namespace arris {
namespace {

// What a node hangs from: one of its four arcs, a terminal, or nothing (free, or an orphan).
constexpr std::uint8_t at_terminal = 4, no_parent = 5;
constexpr std::int32_t infinite_distance = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t scans_between_ticks = 4096;

// Two forests, from the nodes with excess (Side = 1, the source's) and from those that lack it
// (Side = -1, the sink's), along arcs that are not saturated, grow until they touch. The path
// through the contact is then filled; nodes cut off from their root are adopted by a neighbour of
// the same forest or set free.
class Forests {
 public:
  Forests(FlowGraph graph, Job& job);
  MinCut solve();

 private:
  // What the arc between v and its neighbour i can carry: away from the root of v's tree, and
  // from the root towards v.
  template <int Side>
  std::int32_t outward(std::uint32_t v, unsigned i) const {
    return Side > 0 ? graph_.residual(v, i) : graph_.residual_into(v, i);
  }
  template <int Side>
  std::int32_t inward(std::uint32_t v, unsigned i) const {
    return Side > 0 ? graph_.residual_into(v, i) : graph_.residual(v, i);
  }
  template <int Side>
  bool in_forest(std::uint32_t v) const {
    return Side * label_[v] > 0;
  }

  void plant();
  void activate(std::uint32_t v);
  void scan_active();
  template <int Side>
  void scan(std::uint32_t v);
  template <int Side>
  void grow(std::uint32_t v, unsigned i);
  void augment(std::uint32_t v, unsigned i);
  template <int Side>
  std::int64_t path_capacity(std::uint32_t v) const;
  template <int Side>
  void fill_path(std::uint32_t v, std::int32_t amount);
  void make_orphan(std::uint32_t v);
  void adopt_orphans();
  template <int Side>
  void adopt(std::uint32_t v);
  template <int Side>
  void set_free(std::uint32_t v);
  template <int Side>
  std::int32_t distance_to_root(std::uint32_t v);
  template <int Side>
  void stamp_path(std::uint32_t v, std::int32_t distance);

  ResidualGraph graph_;
  Job& job_;
  std::int64_t flow_ = 0, most_ = 0;  // so far, and what all sources could give
  std::uint32_t time_ = 1;            // of the last augmentation
  std::vector<std::int32_t> label_;   // Side x distance to the root, perhaps outdated; 0: free
  std::vector<std::uint32_t> stamp_;  // when the label was last known to be right
  std::vector<std::uint8_t> parent_;
  std::vector<std::uint8_t> active_;  // is queued: may have neighbours to reach
  std::vector<std::uint32_t> queue_, next_queue_, orphans_;
};

Forests::Forests(FlowGraph graph, Job& job)
    : graph_(std::move(graph)),
      job_(job),
      most_(graph_.total_excess()),
      label_(graph_.size(), 0),
      stamp_(graph_.size(), 0),
      parent_(graph_.size(), no_parent),
      active_(graph_.size(), 0) {}

void Forests::plant() {
  flow_ = push_between_neighbours(graph_);
  for (std::uint32_t v = 0; v < graph_.size(); ++v) {
    if (graph_.excess(v) == 0) continue;
    label_[v] = graph_.excess(v) > 0 ? 1 : -1;
    parent_[v] = at_terminal;
    activate(v);
  }
}

void Forests::activate(std::uint32_t v) {
  if (active_[v]) return;
  active_[v] = 1;
  next_queue_.push_back(v);
}

// Takes over neighbour i if it is free, or if its way to the root becomes shorter through v.
template <int Side>
void Forests::grow(std::uint32_t v, unsigned i) {
  const std::uint32_t u = graph_.neighbour(v, i);
  const bool free = label_[u] == 0;
  if (!free && (stamp_[u] > stamp_[v] || Side * label_[u] <= Side * label_[v] + 1)) return;
  parent_[u] = static_cast<std::uint8_t>(graph_.sister(v, i));
  label_[u] = label_[v] + Side;
  stamp_[u] = stamp_[v];
  if (free) activate(u);
}

template <int Side>
void Forests::scan(std::uint32_t v) {
  for (unsigned i = 0; i < 4; ++i) {
    const std::uint32_t u = graph_.neighbour(v, i);
    // A contact may be good for several paths: until the arc is full, or one of both is set free.
    while (outward<Side>(v, i) > 0 && in_forest<-Side>(u)) {
      Side > 0 ? augment(v, i) : augment(u, graph_.sister(v, i));
      if (!in_forest<Side>(v)) return;
    }
    if (outward<Side>(v, i) > 0) grow<Side>(v, i);
  }
}

// What the path between v and its root can carry.
template <int Side>
std::int64_t Forests::path_capacity(std::uint32_t v) const {
  std::int32_t least = std::numeric_limits<std::int32_t>::max();
  for (; parent_[v] != at_terminal; v = graph_.neighbour(v, parent_[v]))
    least = std::min(least, inward<Side>(v, parent_[v]));
  return std::min<std::int64_t>(least, Side * graph_.excess(v));
}

template <int Side>
void Forests::fill_path(std::uint32_t v, std::int32_t amount) {
  while (parent_[v] != at_terminal) {
    const unsigned i = parent_[v];
    const std::uint32_t u = graph_.neighbour(v, i);
    if (Side > 0)
      graph_.push(u, graph_.sister(v, i), amount);
    else
      graph_.push(v, i, amount);
    if (inward<Side>(v, i) == 0) make_orphan(v);
    v = u;
  }
  graph_.add_excess(v, -Side * std::int64_t{amount});
  if (graph_.excess(v) == 0) make_orphan(v);
}

// Fills the path through the arc from v, in the source's forest, to its neighbour i in the sink's.
void Forests::augment(std::uint32_t v, unsigned i) {
  const std::uint32_t u = graph_.neighbour(v, i);
  const auto amount = static_cast<std::int32_t>(
      std::min({std::int64_t{graph_.residual(v, i)}, path_capacity<1>(v), path_capacity<-1>(u)}));
  graph_.push(v, i, amount);
  flow_ += amount;
  fill_path<1>(v, amount);
  fill_path<-1>(u, amount);
  adopt_orphans();
}

void Forests::make_orphan(std::uint32_t v) {
  parent_[v] = no_parent;
  orphans_.push_back(v);
}

void Forests::adopt_orphans() {
  if (++time_ == 0) {  // all stamps would seem to be of the future
    std::fill(stamp_.begin(), stamp_.end(), 0);
    time_ = 1;
  }
  for (std::size_t k = 0; k < orphans_.size(); ++k) {  // grows while it runs
    const std::uint32_t v = orphans_[k];
    in_forest<1>(v) ? adopt<1>(v) : adopt<-1>(v);
  }
  orphans_.clear();
}

// The length of the path from v through its root, infinite if it ends at an orphan.
template <int Side>
std::int32_t Forests::distance_to_root(std::uint32_t v) {
  std::int32_t steps = 0;
  for (; stamp_[v] != time_; v = graph_.neighbour(v, parent_[v])) {
    if (parent_[v] == no_parent) return infinite_distance;
    ++steps;
    if (parent_[v] != at_terminal) continue;
    stamp_[v] = time_;
    label_[v] = Side;
    return steps;
  }
  return steps + Side * label_[v];
}

// Remembers the distances along the path that distance_to_root has walked.
template <int Side>
void Forests::stamp_path(std::uint32_t v, std::int32_t distance) {
  for (; stamp_[v] != time_; v = graph_.neighbour(v, parent_[v])) {
    stamp_[v] = time_;
    label_[v] = Side * distance--;
  }
}

// Hangs v from the neighbour nearest to a root, or sets it free.
template <int Side>
void Forests::adopt(std::uint32_t v) {
  std::int32_t nearest = infinite_distance;
  for (unsigned i = 0; i < 4; ++i) {
    const std::uint32_t u = graph_.neighbour(v, i);
    if (!in_forest<Side>(u) || inward<Side>(v, i) == 0) continue;
    const std::int32_t distance = distance_to_root<Side>(u);
    if (distance == infinite_distance) continue;
    stamp_path<Side>(u, distance);
    if (distance >= nearest) continue;
    nearest = distance;
    parent_[v] = static_cast<std::uint8_t>(i);
  }
  if (nearest == infinite_distance) return set_free<Side>(v);
  stamp_[v] = time_;
  label_[v] = Side * (nearest + 1);
}

// Its children become orphans; neighbours that could reach it must look again.
template <int Side>
void Forests::set_free(std::uint32_t v) {
  label_[v] = 0;
  for (unsigned i = 0; i < 4; ++i) {
    const std::uint32_t u = graph_.neighbour(v, i);
    if (!in_forest<Side>(u)) continue;
    if (inward<Side>(v, i) > 0) activate(u);
    if (parent_[u] == graph_.sister(v, i)) make_orphan(u);
  }
}

void Forests::scan_active() {
  queue_.clear();
  queue_.swap(next_queue_);
  for (std::size_t k = 0; k < queue_.size(); ++k) {
    if (k % scans_between_ticks == 0)
      job_.tick(most_ ? static_cast<double>(flow_) / static_cast<double>(most_) : 0);
    const std::uint32_t v = queue_[k];
    active_[v] = 0;
    if (in_forest<1>(v)) scan<1>(v);
    if (in_forest<-1>(v)) scan<-1>(v);
  }
}

MinCut Forests::solve() {
  job_.tick(0);
  plant();
  while (!next_queue_.empty()) scan_active();
  MinCut cut;
  cut.flow = flow_;
  cut.source_side.resize(graph_.size());
  // The source's forest has grown over all that it can reach.
  for (std::uint32_t v = 0; v < graph_.size(); ++v) cut.source_side[v] = in_forest<1>(v);
  return cut;
}

}  // namespace

MinCut max_flow(FlowGraph graph, Job& job) {
  return Forests(std::move(graph), job).solve();
}

std::int64_t cut_capacity(const FlowGraph& graph, const std::vector<std::uint8_t>& source_side) {
  std::int64_t capacity = 0;
  for (std::size_t n = 0; n < graph.terminal.size(); ++n) {
    const std::int64_t terminal = graph.terminal[n];
    capacity += std::max<std::int64_t>(source_side[n] ? -terminal : terminal, 0);
    if (!source_side[n]) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t u = graph.neighbours[n][i];
      if (u != no_node && !source_side[u]) capacity += graph.capacity[n][i];
    }
  }
  return capacity;
}

}  // namespace arris
