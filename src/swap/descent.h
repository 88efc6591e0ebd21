// The moves of the local minimization: single flips, and chains of flips where those are stuck.
#pragma once

#include <vector>

#include "swap/energy_change.h"
#include "swap/swap.h"

namespace arris {

// Which moves could be accepted from the surface as it stands.
struct Outlook {
  bool flip = false;   // a single flip lowers E
  bool chain = false;  // a chain may begin here
};

class Descent {
 public:
  // Holds on to all of them.
  Descent(const TetMesh& mesh, const EnergyModel& model, const SwapOptions& options, Labels& labels)
      : boundary_(mesh, labels), fidelity_(mesh, model), model_(model), options_(options) {}

  const Boundary& boundary() const noexcept { return boundary_; }
  const FidelityCosts& fidelity() const noexcept { return fidelity_; }

  // What every finite tetrahedron that is not settled is good for as the surface stands.
  std::vector<Outlook> survey(unsigned threads);

  // Flips t if that is allowed and lowers E (paper, algorithm 1).
  bool try_flip(Tet t);

  // Flips t although that raises E, then again and again the tetrahedron next to the chain that
  // costs least, and keeps the chain as soon as E is lower than before it; else undoes it all. This
  // is the variable-depth search of Kernighan and Lin (1970): it finds pairs, fans round an edge
  // and parts of a vertex star without being told which. Every step is a simple flip, so the
  // topology needs no other argument; a sample may leave the surface on the way if it is back at
  // the end.
  bool try_chain(Tet t);

  // Of the last move that was made: the tetrahedra flipped, each once, and what E lost by it.
  const std::vector<Tet>& flipped() const noexcept { return chain_; }
  double change() const noexcept { return change_.value; }

 private:
  bool may_move(Tet t) const noexcept {
    return boundary_.mesh().is_finite(t) && (options_.frozen.empty() || options_.frozen[t] == 0);
  }
  bool is_due(Tet t) const noexcept { return options_.settled.empty() || options_.settled[t] == 0; }
  Outlook outlook(Tet t) const;  // of one whose flip is simple
  // The sample that a simple flip of t takes off the surface, if those must stay; or no_index.
  Index lost_sample(Tet t) const noexcept;
  void extend(Tet t, const Change& change);
  // The best tetrahedron to extend the chain with, and what its flip changes; or no_tet.
  Tet cheapest_next(Change& change);
  bool succeeds() const;
  void undo();

  Boundary boundary_;
  FidelityCosts fidelity_;
  const EnergyModel& model_;
  const SwapOptions& options_;
  std::vector<Tet> chain_, candidates_;
  std::vector<Index> lost_;  // samples that the chain took off the surface, perhaps for a while
  Change change_;            // of E by the chain
};

}  // namespace arris
