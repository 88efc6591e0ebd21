// Local minimization of E by flipping tetrahedra between inside and outside (paper, section 4,
// algorithm 1).
#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "energy/model.h"
#include "tetra/tet_mesh.h"

namespace arris {

struct SwapOptions {
  // Refuse flips that take a sample off the surface.
  bool keep_samples = true;
  // Tetrahedra that must keep their label (1), or empty. Infinite ones always keep theirs.
  std::vector<std::uint8_t> frozen;
  // Tetrahedra (1) for which moves were sought before: they wait until one is made beside them. Or
  // empty.
  std::vector<std::uint8_t> settled;
  // Whether to report E: it takes a look at the whole boundary.
  bool with_energy = true;
};

struct SwapResult {
  // E before the first round and after each; never increases. Without E: what it lost since.
  std::vector<double> energy;
  std::uint64_t accepted = 0;  // moves
  std::uint64_t flipped = 0;   // tetrahedra, counted once per flip
};

// E of the whole boundary of the labels, from scratch. The same for every number of threads.
double total_energy(const TetMesh& mesh, const EnergyModel& model, const Labels& labels,
                    unsigned threads = 1);

// Changes `labels` until no single flip lowers E, nor any short chain of flips tried where the last
// moves changed something. On entry the boundary must be a 2-manifold; it stays one, with the same
// topology, after every accepted move. Deterministic. Throws Failure(cancelled).
// Complexity: one pass over the tetrahedra, then time in proportion to the moves.
SwapResult swap_tetrahedra(const TetMesh& mesh, const EnergyModel& model,
                           const SwapOptions& options, Labels& labels, Job& job);

}  // namespace arris
