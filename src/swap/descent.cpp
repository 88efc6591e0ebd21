#include "swap/descent.h"

#include <algorithm>

#include "base/distinct.h"
#include "base/parallel.h"

namespace arris {
namespace {

// How far above its start, in E, a chain may climb: five facets' worth of distance (a typical one
// costs 0.1) and of curvature (an edge of one spacing turned by a right angle costs 0.8 lambda). At
// lambda = 0.1 that is 1, as much as any chain needed that won on eight clouds of all kinds (E is
// the same without a bound) and on heavily disturbed solids (with half of it, a cube stops at 1.04
// of its curvature instead of 1.00). Most chains would begin higher than that, and are not tried.
double highest_climb(const EnergyModel& model) {
  return 0.5 + 5 * model.lambda;
}

}  // namespace

Index Descent::lost_sample(Tet t) const noexcept {
  if (!options_.keep_samples) return no_index;
  const Index v = boundary_.removed_vertex(t);
  return v != no_index && boundary_.mesh().is_sample(v) ? v : no_index;
}

std::vector<Outlook> Descent::survey(unsigned threads) {
  std::vector<Outlook> outlooks(boundary_.mesh().finite);
  std::vector<std::uint8_t> movable(outlooks.size());
  parallel_for(outlooks.size(), threads, [&](std::size_t i) {
    const auto t = static_cast<Tet>(i);
    movable[t] = is_due(t) && boundary_.facets(t) != 0 && may_move(t) && boundary_.is_simple(t);
  });
  fidelity_.fill(threads, [&](Tet t) { return movable[t] != 0; });
  parallel_for(outlooks.size(), threads, [&](std::size_t t) {
    if (movable[t]) outlooks[t] = outlook(static_cast<Tet>(t));
  });
  return outlooks;
}

Outlook Descent::outlook(Tet t) const {
  const Change change = flip_change(boundary_, model_, fidelity_, t);
  return {change.lowers() && lost_sample(t) == no_index, change.value <= highest_climb(model_)};
}

bool Descent::try_flip(Tet t) {
  if (!may_move(t) || lost_sample(t) != no_index || !boundary_.is_simple(t)) return false;
  change_ = flip_change(boundary_, model_, fidelity_, t);
  if (!change_.lowers()) return false;
  boundary_.flip(t);
  chain_.assign(1, t);
  return true;
}

bool Descent::try_chain(Tet t) {
  // Longer chains win next to nothing: on disturbed cubes 4 reaches 1.067 of the true curvature, 8
  // and 16 both 1.000.
  constexpr std::size_t longest = 8;
  if (!may_move(t) || !boundary_.is_simple(t)) return false;
  chain_.clear();
  lost_.clear();
  change_ = {};
  Change step = flip_change(boundary_, model_, fidelity_, t);
  for (Tet next = t; next != no_tet; next = cheapest_next(step)) {
    extend(next, step);
    if (succeeds()) return true;
    if (chain_.size() == longest || change_.value > highest_climb(model_)) break;
  }
  undo();
  return false;
}

void Descent::extend(Tet t, const Change& change) {
  if (const Index v = lost_sample(t); v != no_index) lost_.push_back(v);
  boundary_.flip(t);
  chain_.push_back(t);
  change_ += change;
}

Tet Descent::cheapest_next(Change& change) {
  candidates_.clear();
  for (Tet t : chain_)
    for (Tet n : boundary_.mesh().neighbours[t])
      if (std::find(chain_.begin(), chain_.end(), n) == chain_.end()) candidates_.push_back(n);
  keep_distinct(candidates_);
  Tet best = no_tet;
  for (Tet t : candidates_) {
    if (!may_move(t) || !boundary_.is_simple(t)) continue;
    const Change c = flip_change(boundary_, model_, fidelity_, t);
    if (best == no_tet || c.value < change.value) {
      best = t;
      change = c;
    }
  }
  return best;
}

bool Descent::succeeds() const {
  return change_.lowers() && std::all_of(lost_.begin(), lost_.end(),
                                         [this](Index v) { return boundary_.on_surface(v); });
}

// The reverse of a simple flip is simple.
void Descent::undo() {
  for (; !chain_.empty(); chain_.pop_back()) boundary_.flip(chain_.back());
}

}  // namespace arris
