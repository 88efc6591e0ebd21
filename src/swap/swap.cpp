#include "swap/swap.h"

#include <bit>
#include <cmath>

#include "base/parallel.h"
#include "energy/curvature.h"
#include "swap/descent.h"

namespace arris {
namespace {

// Tetrahedra to look at, in the order in which they were pushed; each waits at most once.
class Queue {
 public:
  explicit Queue(std::size_t tetrahedra) : waits_(tetrahedra, 0) {}
  bool empty() const noexcept { return next_.empty(); }
  void push(Tet t) {
    if (waits_[t] != 0) return;
    waits_[t] = 1;
    next_.push_back(t);
  }
  // Visits what waits now; what the visits push waits for the next generation.
  template <class Visit>
  void generation(Visit&& visit) {
    now_.swap(next_);
    next_.clear();
    for (std::size_t k = 0; k < now_.size(); ++k) {
      waits_[now_[k]] = 0;
      visit(now_[k], static_cast<double>(k) / static_cast<double>(now_.size()));
    }
  }

 private:
  std::vector<std::uint8_t> waits_;
  std::vector<Tet> now_, next_;
};

double energy_of(const FidelityCosts& costs, const Labels& labels, unsigned threads) {
  const TetMesh& mesh = costs.mesh();
  const double fidelity = parallel_sum(mesh.finite, threads, [&](std::size_t t) {
    double sum = 0;
    if (labels[t] == 0) return sum;
    for (int i = 0; i < 4; ++i)
      if (labels[mesh.neighbours[t][static_cast<std::size_t>(i)]] == 0)
        sum += costs(static_cast<Tet>(t), i);
    return sum;
  });
  return fidelity + (costs.model().curvature == Curvature::cotangent
                         ? cotangent_energy(mesh, costs.model(), labels)
                         : polyhedral_energy(mesh, costs.model(), labels, threads));
}

class Swapper {
 public:
  Swapper(const TetMesh& mesh, const EnergyModel& model, const SwapOptions& options, Labels& labels,
          Job& job)
      : mesh_(mesh),
        model_(model),
        descent_(mesh, model, options, labels),
        with_energy_(options.with_energy),
        job_(job),
        flips_(mesh.finite),
        chains_(mesh.finite),
        seen_(mesh.size(), 0) {}

  SwapResult run() {
    if (with_energy_)
      energy_ = energy_of(descent_.fidelity(), descent_.boundary().labels(), job_.threads());
    result_.energy.push_back(energy_);
    push_promising();
    while (!flips_.empty() || !chains_.empty()) {
      // Chains are dear: only what single flips leave behind is worth one.
      if (!flips_.empty())
        generation(flips_, [this](Tet t) { return descent_.try_flip(t); });
      else
        generation(chains_, [this](Tet t) { return descent_.try_chain(t); });
    }
    return std::move(result_);
  }

 private:
  template <class Try>
  void generation(Queue& queue, Try&& attempt) {
    constexpr std::size_t between_ticks = 4096;
    // The number of generations is not known: each counts half of what is left.
    const double left = std::ldexp(1.0, -static_cast<int>(result_.energy.size() - 1));
    std::size_t visits = 0;
    queue.generation([&](Tet t, double fraction) {
      if (visits++ % between_ticks == 0) job_.tick(1 - left + 0.5 * left * fraction);
      if (attempt(t)) accept();
    });
    result_.energy.push_back(energy_);
  }

  void accept() {
    const std::vector<Tet>& flipped = descent_.flipped();
    energy_ += descent_.change();
    ++result_.accepted;
    result_.flipped += flipped.size();
    for (Tet t : flipped) push_round(t);
  }

  // Most tetrahedra next to the surface are of no use as it stands: all are examined in parallel,
  // before the first move. Later moves push what they change.
  void push_promising() {
    const std::vector<Outlook> outlook = descent_.survey(job_.threads());
    for (Tet t = 0; t < mesh_.finite; ++t) {
      if (outlook[t].flip) flips_.push(t);
      if (outlook[t].chain) chains_.push(t);
    }
  }

  // Only a tetrahedron next to the surface can be flipped.
  void push(Tet t) {
    if (!mesh_.is_finite(t) || descent_.boundary().facets(t) == 0) return;
    flips_.push(t);
    chains_.push(t);
  }

  // All tetrahedra for which the flip of t changed what their own flip would do.
  void push_round(Tet t) {
    const unsigned mask = descent_.boundary().facets(t);
    const int count = std::popcount(mask);
    if (model_.curvature == Curvature::cotangent || descent_.flipped().size() > 1) {
      for (Index v : mesh_.vertices[t]) push_star(v, t);
      return;
    }
    for (const auto& [in, out] : edge_corners) {  // every pair of facets has an edge
      EdgeStep s = next_round_edge(mesh_, {t, in, out});
      for (; s.t != t; s = next_round_edge(mesh_, s)) push(s.t);
    }
    push(t);
    // The vertex that left the surface, or came to it.
    if (count == 1)
      push_star(mesh_.vertices[t][static_cast<std::size_t>(std::countr_zero(mask))], t);
    if (count == 3)
      push_star(mesh_.vertices[t][static_cast<std::size_t>(std::countr_one(mask))], t);
  }

  void push_star(Index v, Tet seed) {
    star_.assign(1, seed);
    seen_[seed] = 1;
    for (std::size_t k = 0; k < star_.size(); ++k)
      for (std::size_t i = 0; i < 4; ++i) {
        const Tet n = mesh_.neighbours[star_[k]][i];
        if (mesh_.vertices[star_[k]][i] == v || seen_[n] != 0) continue;
        seen_[n] = 1;
        star_.push_back(n);
      }
    for (Tet t : star_) {
      seen_[t] = 0;
      push(t);
    }
  }

  const TetMesh& mesh_;
  const EnergyModel& model_;
  Descent descent_;
  bool with_energy_;
  Job& job_;
  Queue flips_, chains_;
  std::vector<std::uint8_t> seen_;  // marks of push_star, all 0 between calls
  std::vector<Tet> star_;
  SwapResult result_;
  double energy_ = 0;
};

}  // namespace

double total_energy(const TetMesh& mesh, const EnergyModel& model, const Labels& labels,
                    unsigned threads) {
  return energy_of(FidelityCosts(mesh, model), labels, threads);
}

SwapResult swap_tetrahedra(const TetMesh& mesh, const EnergyModel& model,
                           const SwapOptions& options, Labels& labels, Job& job) {
  return Swapper(mesh, model, options, labels, job).run();
}

}  // namespace arris
