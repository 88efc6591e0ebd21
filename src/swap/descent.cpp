#include "swap/descent.h"

#include <algorithm>

#include "base/parallel.h"

namespace arris {
namespace {

// How far above its start, in E, a chain may climb: by what one bad flip costs, four typical facets
// of fidelity and six edges of one spacing folded by a right angle. At λ = 0.1 the sum is 1: with
// 0.25, single wrong tetrahedra stay on a heavily disturbed cube; without a bound, E ends at most
// 0.1 % lower on the demo's scan, in half as much time again.
constexpr double climb_of_fidelity = 0.5, climb_of_curvature = 5;

}  // namespace

Descent::Descent(const TetMesh& mesh, const EnergyModel& model, const SwapOptions& options,
                 Labels& labels)
    : boundary_(mesh, labels),
      fidelity_(mesh, model),
      model_(model),
      options_(options),
      highest_climb_(climb_of_fidelity + climb_of_curvature * model.lambda) {}

Index Descent::lost_sample(Tet t) const noexcept {
  if (!options_.keep_samples) return no_index;
  const Index v = boundary_.removed_vertex(t);
  return v != no_index && boundary_.mesh().is_sample(v) ? v : no_index;
}

std::vector<Outlook> Descent::survey(unsigned threads) {
  std::vector<Outlook> outlooks(boundary_.mesh().finite);
  fidelity_.fill(threads, [this](Tet t) { return boundary_.facets(t) != 0; });
  parallel_for(outlooks.size(), threads,
               [&](std::size_t t) { outlooks[t] = outlook(static_cast<Tet>(t)); });
  return outlooks;
}

Outlook Descent::outlook(Tet t) const {
  if (boundary_.facets(t) == 0 || !may_move(t) || !boundary_.is_simple(t)) return {};
  const Change change = flip_change(boundary_, model_, fidelity_, t);
  return {change.lowers() && lost_sample(t) == no_index, change.value <= highest_climb_};
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
    if (chain_.size() == longest || change_.value > highest_climb_) break;
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
  std::sort(candidates_.begin(), candidates_.end());
  candidates_.erase(std::unique(candidates_.begin(), candidates_.end()), candidates_.end());
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
