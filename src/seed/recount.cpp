#include "seed/recount.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <queue>
#include <utility>

#include "base/distinct.h"

namespace arris {
namespace {

// Strength of a vote without doubt. Sums of votes are in its units below.
constexpr int full_vote = Votes::levels - 2;
// What a region must win to be turned. On clean clouds none wins more than 3.5; a tunnel or the
// end of a bar that went to the wrong side, 5 to 40.
constexpr int least_gain = 4 * full_vote;
// How far growing may go below its best so far: a tunnel of three spacings radius has to lose 15
// at its first end before it wins at the other. 60 and 120 find the same.
constexpr int deepest_loss = 30 * full_vote;
// Most balls of a region are large, or the votes at its rim want it turned three to one. Where two
// sheets taper to an edge half of the balls are small, and all votes contradict each other; in
// tunnels and bars 0.8 are large.
constexpr double least_firm = 0.7;
constexpr int clear_majority = 3;
// Keys of the queue: what turning a tetrahedron wins in shares of what its votes weigh. By the
// wins alone regions grow through slivers, which have few votes, and miss half of the tunnels.
constexpr int key_steps = 1000;
// Growing again from the heart of a region that did not win would find the same.
constexpr std::size_t heart = 16;

class Recount {
 public:
  Recount(const TetMesh& mesh, const Votes& votes, const std::vector<std::uint8_t>& firm,
          std::vector<Seed>& label)
      : mesh_(mesh), votes_(votes), firm_(firm), label_(label), in_(mesh.finite, 0) {
    collect_poles();
  }

  std::size_t run() {
    std::size_t turned = 0;
    std::vector<std::uint8_t> tried(mesh_.finite, 0);
    for (Tet t : starts()) {
      if (tried[t]) continue;
      const int gain = grow(t);
      for (std::size_t k = 0; k < std::min(region_.size(), heart); ++k) tried[region_[k]] = 1;
      if (gain >= least_gain && is_pure() && (is_firm() || is_clear(gain))) {
        for (std::size_t k = 0; k < kept_; ++k)
          label_[region_[k]] = label_[region_[k]] == seed_inside ? seed_outside : seed_inside;
        turned += kept_;
      }
      for (Tet r : region_) in_[r] = 0;
    }
    return turned;
  }

 private:
  bool is_known(Tet t) const { return !mesh_.is_finite(t) || label_[t] != seed_free; }
  bool is_inside(Tet t) const { return mesh_.is_finite(t) && label_[t] == seed_inside; }
  bool is_in(Tet t) const { return mesh_.is_finite(t) && in_[t]; }

  template <class Body>
  void for_pole_ends(Body&& body) const {
    for (std::size_t v = 0; v < votes_.pole.size(); ++v)
      if (votes_.pole[v] != 0)
        for (Tet t : votes_.pole_pair[v])
          if (t != no_tet && mesh_.is_finite(t)) body(t, static_cast<Index>(v));
  }

  // The samples of which a tetrahedron is a pole.
  void collect_poles() {
    first_.assign(mesh_.finite + 1, 0);
    for_pole_ends([&](Tet t, Index) { ++first_[t + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    pole_.resize(first_.back());
    std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
    for_pole_ends([&](Tet t, Index v) { pole_[at[t]++] = v; });
  }

  // For each vote at t: the other end, and what is won if just one of the two is turned.
  template <class Body>
  void for_votes(Tet t, Body&& body) const {
    const auto tell = [&](Tet other, std::uint8_t packed) {
      const Vote vote = Votes::unpack(packed);
      if (vote.strength == 0 || !is_known(other)) return;
      const bool heeded = (is_inside(t) != is_inside(other)) == vote.opposite;
      body(other, heeded ? -int{vote.strength} : int{vote.strength});
    };
    for (std::size_t i = 0; i < 4; ++i) {
      const Tet n = mesh_.neighbours[t][i];
      const bool mine = t < n || !mesh_.is_finite(n);
      const std::size_t facet =
          mine ? 4 * static_cast<std::size_t>(t) + i
               : 4 * static_cast<std::size_t>(n) + static_cast<std::size_t>(mesh_.facet_to(n, t));
      tell(n, votes_.facet[facet]);
    }
    for (std::uint32_t k = first_[t]; k < first_[t + 1]; ++k) {
      const auto& pair = votes_.pole_pair[pole_[k]];
      const Tet other = pair[0] == t ? pair[1] : pair[0];
      tell(other == no_tet ? outside() : other, votes_.pole[pole_[k]]);
    }
  }

  Tet outside() const { return static_cast<Tet>(mesh_.finite); }

  // Won if t changes between the region and the rest.
  struct Gain {
    int won = 0, all = 0;
    int key() const { return won * key_steps / std::max(all, 1); }
  };
  Gain gain(Tet t) const {
    Gain g;
    for_votes(t, [&](Tet other, int won) {
      g.won += is_in(other) ? -won : won;
      g.all += std::abs(won);
    });
    return g;
  }

  // The tetrahedra that a refused vote speaks to.
  std::vector<Tet> contradicted() const {
    std::vector<Tet> found;
    const auto look = [&](Tet a, Tet b, std::uint8_t packed) {
      const Vote vote = Votes::unpack(packed);
      if (vote.strength == 0 || !is_known(a) || !is_known(b)) return;
      if ((is_inside(a) != is_inside(b)) == vote.opposite) return;
      for (Tet t : {a, b})
        if (mesh_.is_finite(t)) found.push_back(t);
    };
    for (std::size_t id = 0; id < votes_.facet.size(); ++id)
      if (votes_.facet[id] != 0)
        look(static_cast<Tet>(id / 4), mesh_.neighbours[id / 4][id % 4], votes_.facet[id]);
    const auto end = [&](Tet t) { return t == no_tet ? outside() : t; };
    for (std::size_t v = 0; v < votes_.pole.size(); ++v)
      if (votes_.pole[v] != 0)
        look(end(votes_.pole_pair[v][0]), end(votes_.pole_pair[v][1]), votes_.pole[v]);
    keep_distinct(found);
    return found;
  }

  // Those, the ones that win most first.
  std::vector<Tet> starts() const {
    std::vector<std::pair<int, Tet>> found;
    for (Tet t : contradicted()) found.push_back({-gain(t).won, t});
    std::sort(found.begin(), found.end());
    std::vector<Tet> order;
    order.reserve(found.size());
    for (const auto& [lost, t] : found) order.push_back(t);
    return order;
  }

  // Grows region_ from `start`; its first kept_ win most. Returns what they win.
  int grow(Tet start) {
    region_.clear();
    kept_ = 0;
    std::priority_queue<std::pair<int, Tet>> queue;
    queue.push({gain(start).key(), start});
    int sum = 0, best = 0;
    while (!queue.empty()) {
      const auto [key, t] = queue.top();
      queue.pop();
      if (in_[t]) continue;
      const Gain g = gain(t);
      if (key != g.key()) continue;  // it was queued again since
      sum += g.won;
      if (sum < best - deepest_loss) break;
      in_[t] = 1;
      region_.push_back(t);
      if (sum > best) {
        best = sum;
        kept_ = region_.size();
      }
      for_votes(t, [&](Tet n, int) {
        if (mesh_.is_finite(n) && !in_[n]) queue.push({gain(n).key(), n});
      });
    }
    return best;
  }

  // What went wrong went to one side. Where two sheets taper to an edge regions of both labels win
  // a lot, and chance decides.
  bool is_pure() const {
    return std::all_of(region_.begin(), region_.begin() + static_cast<std::ptrdiff_t>(kept_),
                       [&](Tet t) { return label_[t] == label_[region_[0]]; });
  }

  bool is_firm() const {
    const auto end = region_.begin() + static_cast<std::ptrdiff_t>(kept_);
    const auto firm = std::count_if(region_.begin(), end, [&](Tet t) { return firm_[t] != 0; });
    return static_cast<double>(firm) >= least_firm * static_cast<double>(kept_);
  }

  // What is for turning exceeds what is against it by `gain`.
  bool is_clear(int gain) {
    for (std::size_t k = kept_; k < region_.size(); ++k) in_[region_[k]] = 0;
    int against = 0;
    for (std::size_t k = 0; k < kept_; ++k)
      for_votes(region_[k], [&](Tet other, int won) {
        if (!is_in(other) && won < 0) against -= won;
      });
    return against + gain >= clear_majority * against;
  }

  const TetMesh& mesh_;
  const Votes& votes_;
  const std::vector<std::uint8_t>& firm_;
  std::vector<Seed>& label_;
  std::vector<std::uint32_t> first_;  // pole_[first_[t] .. first_[t + 1])
  std::vector<Index> pole_;
  std::vector<std::uint8_t> in_;  // 1 in the region
  std::vector<Tet> region_;       // in the order in which it grew
  std::size_t kept_ = 0;
};

}  // namespace

std::size_t recount_votes(const TetMesh& mesh, const Votes& votes,
                          const std::vector<std::uint8_t>& firm, std::vector<Seed>& label) {
  return Recount(mesh, votes, firm, label).run();
}

}  // namespace arris
