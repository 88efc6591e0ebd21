#include <algorithm>
#include <limits>

#include "cut/residual_graph.h"
#include "flow_algorithms.h"

namespace arris {
namespace {

constexpr std::uint8_t at_terminal = 4, no_parent = 5;
constexpr std::int32_t infinite_distance = std::numeric_limits<std::int32_t>::max();

class BoykovKolmogorov {
 public:
  BoykovKolmogorov(FlowGraph graph, Job& job)
      : g_(std::move(graph)), job_(job), stamp_(g_.size(), 0), active_(g_.size(), 0) {}
  MinCut solve();

 private:
  // Residual of the arc between v and its neighbour i: away from the root, and towards v.
  template <int Side>
  std::int32_t outward(std::uint32_t v, unsigned i) {
    return Side > 0 ? g_.residual(v, i) : g_.residual(g_.neighbour(v, i), g_.sister(v, i));
  }
  template <int Side>
  std::int32_t inward(std::uint32_t v, unsigned i) {
    return outward<-Side>(v, i);
  }
  void plant();
  void activate(std::uint32_t v);
  template <int Side> void scan(std::uint32_t v);
  template <int Side> std::int64_t path_capacity(std::uint32_t v);
  template <int Side> void push_path(std::uint32_t v, std::int32_t amount);
  void augment(std::uint32_t v, unsigned i);
  void orphan(std::uint32_t v);
  template <int Side> std::int32_t distance_to_root(std::uint32_t v);
  template <int Side> void stamp_path(std::uint32_t v, std::int32_t distance);
  template <int Side> void adopt(std::uint32_t v);

  ResidualGraph g_;
  Job& job_;
  std::int64_t flow_ = 0;
  std::uint32_t time_ = 0;
  std::vector<std::uint32_t> stamp_;   // when the label was last known to be right
  std::vector<std::uint8_t> active_;   // in the queue
  std::vector<std::uint32_t> queue_, next_queue_, orphans_;
};

void BoykovKolmogorov::activate(std::uint32_t v) {
  if (active_[v]) return;
  active_[v] = 1;
  next_queue_.push_back(v);
}

void BoykovKolmogorov::plant() {
  for (std::uint32_t n = 0; n < g_.size(); ++n) {
    const std::int64_t e = g_.excess(n);
    g_.label(n) = e > 0 ? 1 : e < 0 ? -1 : 0;
    g_.parent(n) = e ? at_terminal : no_parent;
    if (e) activate(n);
  }
}

void BoykovKolmogorov::orphan(std::uint32_t v) {
  g_.parent(v) = no_parent;
  orphans_.push_back(v);
}

template <int Side>
std::int64_t BoykovKolmogorov::path_capacity(std::uint32_t v) {
  std::int32_t least = std::numeric_limits<std::int32_t>::max();
  while (g_.parent(v) != at_terminal) {
    const unsigned i = g_.parent(v);
    least = std::min(least, inward<Side>(v, i));
    v = g_.neighbour(v, i);
  }
  return std::min<std::int64_t>(least, Side * g_.excess(v));
}

template <int Side>
void BoykovKolmogorov::push_path(std::uint32_t v, std::int32_t amount) {
  while (g_.parent(v) != at_terminal) {
    const unsigned i = g_.parent(v), j = g_.sister(v, i);
    const std::uint32_t u = g_.neighbour(v, i);
    std::int32_t& in = Side > 0 ? g_.residual(u, j) : g_.residual(v, i);
    std::int32_t& out = Side > 0 ? g_.residual(v, i) : g_.residual(u, j);
    in -= amount;
    out += amount;
    if (in == 0) orphan(v);
    v = u;
  }
  g_.excess(v) -= Side * amount;
  if (g_.excess(v) == 0) orphan(v);
}

// The length of the path from v to its root, infinite if it ends at an orphan.
template <int Side>
std::int32_t BoykovKolmogorov::distance_to_root(std::uint32_t v) {
  std::int32_t steps = 0;
  while (true) {
    if (stamp_[v] == time_) return steps + Side * g_.label(v);
    if (g_.parent(v) == no_parent) return infinite_distance;
    ++steps;
    if (g_.parent(v) == at_terminal) {
      stamp_[v] = time_;
      g_.label(v) = Side;
      return steps;
    }
    v = g_.neighbour(v, g_.parent(v));
  }
}

template <int Side>
void BoykovKolmogorov::stamp_path(std::uint32_t v, std::int32_t distance) {
  for (; stamp_[v] != time_; v = g_.neighbour(v, g_.parent(v))) {
    stamp_[v] = time_;
    g_.label(v) = Side * distance--;
  }
}

template <int Side>
void BoykovKolmogorov::adopt(std::uint32_t v) {
  std::int32_t nearest = infinite_distance;
  for (unsigned i = 0; i < 4; ++i) {
    const std::uint32_t u = g_.neighbour(v, i);
    if (Side * g_.label(u) <= 0 || inward<Side>(v, i) == 0) continue;
    const std::int32_t distance = distance_to_root<Side>(u);
    if (distance == infinite_distance) continue;
    stamp_path<Side>(u, distance);
    if (distance >= nearest) continue;
    nearest = distance;
    g_.parent(v) = static_cast<std::uint8_t>(i);
  }
  if (nearest != infinite_distance) {
    stamp_[v] = time_;
    g_.label(v) = Side * (nearest + 1);
    return;
  }
  for (unsigned i = 0; i < 4; ++i) {
    const std::uint32_t u = g_.neighbour(v, i);
    if (u == v || Side * g_.label(u) <= 0) continue;
    if (inward<Side>(v, i) > 0) activate(u);
    if (g_.parent(u) == g_.sister(v, i)) orphan(u);
  }
  g_.label(v) = 0;
}

void BoykovKolmogorov::augment(std::uint32_t v, unsigned i) {
  const std::uint32_t u = g_.neighbour(v, i);
  const auto amount = static_cast<std::int32_t>(
      std::min({std::int64_t{g_.residual(v, i)}, path_capacity<1>(v), path_capacity<-1>(u)}));
  g_.residual(v, i) -= amount;
  g_.residual(u, g_.sister(v, i)) += amount;
  flow_ += amount;
  push_path<1>(v, amount);
  push_path<-1>(u, amount);
  ++time_;
  for (std::size_t k = 0; k < orphans_.size(); ++k)
    g_.label(orphans_[k]) > 0 ? adopt<1>(orphans_[k]) : adopt<-1>(orphans_[k]);
  orphans_.clear();
}

template <int Side>
void BoykovKolmogorov::scan(std::uint32_t v) {
  for (unsigned i = 0; i < 4;) {
    const std::uint32_t u = g_.neighbour(v, i);
    const std::int32_t l = Side * g_.label(u);
    if (u == v || outward<Side>(v, i) == 0) {
      ++i;
    } else if (l < 0) {
      Side > 0 ? augment(v, i) : augment(u, g_.sister(v, i));
      if (Side * g_.label(v) <= 0) return;
    } else {
      const bool nearer = l > 0 && stamp_[u] <= stamp_[v] && l > Side * g_.label(v) + 1;
      if (l == 0 || nearer) {
        g_.parent(u) = static_cast<std::uint8_t>(g_.sister(v, i));
        g_.label(u) = g_.label(v) + Side;
        stamp_[u] = stamp_[v];
        if (l == 0) activate(u);
      }
      ++i;
    }
  }
}

MinCut BoykovKolmogorov::solve() {
  plant();
  while (!next_queue_.empty()) {
    queue_.clear();
    queue_.swap(next_queue_);
    for (std::size_t k = 0; k < queue_.size(); ++k) {
      if (k % 4096 == 0) job_.tick(0);
      const std::uint32_t v = queue_[k];
      active_[v] = 0;
      if (g_.label(v) > 0) scan<1>(v);
      else if (g_.label(v) < 0) scan<-1>(v);
    }
  }
  MinCut cut;
  cut.flow = flow_;
  cut.source_side.resize(g_.size());
  for (std::uint32_t n = 0; n < g_.size(); ++n) cut.source_side[n] = g_.label(n) > 0;
  return cut;
}

}  // namespace

MinCut boykov_kolmogorov(FlowGraph graph, Job& job) {
  return BoykovKolmogorov(std::move(graph), job).solve();
}

}  // namespace arris
