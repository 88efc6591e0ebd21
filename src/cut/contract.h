// From the dual graph of the tetrahedra to the flow graph of the undecided ones, and back.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "cut/max_flow.h"
#include "tetra/tet_mesh.h"

namespace arris {

// What is known of a tetrahedron before the cut.
using Seed = std::uint8_t;
inline constexpr Seed seed_outside = 0;
inline constexpr Seed seed_inside = 1;
inline constexpr Seed seed_free = 2;

// A labelling of the tetrahedra costs, summed over all of them,
//   capacity[t][i]  for each t inside whose neighbour i is outside,
//   preference[t]   for each t outside, where it is positive,
//  -preference[t]   for each t inside, where it is negative,
// and must agree with every seed. Capacities lie in [0, max_arc_capacity].
struct CutProblem {
  std::vector<Seed> seed;                             // per tetrahedron
  std::vector<std::array<std::int32_t, 4>> capacity;  // per tetrahedron and facet
  std::vector<std::int64_t> preference;               // per tetrahedron, or empty: none has any
};

// The problem without the tetrahedra whose label is known: an arc to one of them is a terminal, an
// arc between two is a constant. Cost of labels = cut_capacity(graph, ...) + constant.
struct ContractedCut {
  FlowGraph graph;
  std::vector<Tet> tetrahedron;  // per node; ascending, so neighbours stay near in memory
  std::int64_t constant = 0;
};

// O(tetrahedra); uses the threads of the job. Throws Failure: cancelled, internal (sizes that do
// not match the mesh).
ContractedCut contract(const TetMesh& mesh, const CutProblem& problem, Job& job);

// The labels of all tetrahedra: those of the seeds, and inside for the free ones on the source
// side.
Labels scatter(const std::vector<Seed>& seed, const std::vector<Tet>& tetrahedron,
               const std::vector<std::uint8_t>& source_side);

// The cost of any labels that agree with the seeds, from scratch: the check of the two above.
std::int64_t labelling_cost(const TetMesh& mesh, const CutProblem& problem, const Labels& labels);

}  // namespace arris
