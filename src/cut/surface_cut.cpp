#include "cut/surface_cut.h"

#include <algorithm>
#include <cmath>

#include "base/failure.h"
#include "base/parallel.h"
#include "cut/contract.h"
#include "cut/facet_costs.h"
#include "cut/max_flow.h"

namespace arris {
namespace {

// Integer steps per unit of dimensionless cost. A typical facet costs 0.1, so capacities keep five
// digits, and one of a thousand units still fits; longer ones saturate, they are never cut anyway.
constexpr double capacity_steps = 0x1p20;
constexpr double largest_capacity = 0x1p30 - 1;

// How much a soft seed weighs against the facets of its tetrahedron: the cut overrules it when that
// saves more than this share of their cost. Measured on 342 clouds: 1/4 to 1/2 give the same
// topology on clean ones, with noise of 0.5 % 24 against 22 of 38 are right, and 0 (no soft seeds)
// loses thin parts.
constexpr double seed_trust = 0.3;
// The same for a hint: above the rounding of costs that are equal, below what a stack of slivers
// needs to outvote the cut. Measured on blue samples of polyhedra: at 0.003 edges lose 2 % to
// needles along them, at 0.1 faces fold back.
constexpr double hint_trust = 0.04;

std::int32_t capacity(double cost) {
  return static_cast<std::int32_t>(std::min(std::floor(cost * capacity_steps), largest_capacity));
}

bool is_soft(const Seeds& seeds, Tet t) {
  return seeds.label[t] == seed_free || !seeds.firm[t];
}

CutProblem make_problem(const TetMesh& mesh, const EnergyModel& model, const Seeds& seeds,
                        const std::vector<double>& curvature, unsigned threads) {
  CutProblem problem;
  problem.seed.assign(mesh.size(), seed_outside);
  parallel_for(mesh.finite, threads, [&](std::size_t t) {
    const auto tet = static_cast<Tet>(t);
    problem.seed[t] = is_soft(seeds, tet) ? seed_free : seeds.label[t];
  });
  problem.capacity.assign(mesh.size(), {0, 0, 0, 0});
  parallel_for(mesh.size(), threads, [&](std::size_t i) {
    const auto t = static_cast<Tet>(i);
    for (int f = 0; f < 4; ++f) {  // each facet from its lower side, for both
      const Tet n = mesh.neighbours[t][static_cast<std::size_t>(f)];
      if (n < t || (problem.seed[t] != seed_free && problem.seed[n] != seed_free)) continue;
      const std::int32_t both = capacity(facet_cost(mesh, model, curvature, t, f));
      problem.capacity[t][static_cast<std::size_t>(f)] = both;
      problem.capacity[n][static_cast<std::size_t>(mesh.facet_to(n, t))] = both;
    }
  });
  problem.preference.assign(mesh.size(), 0);
  parallel_for(mesh.finite, threads, [&](std::size_t t) {
    if (problem.seed[t] != seed_free || seeds.label[t] == seed_free) return;
    const auto& c = problem.capacity[t];
    const double sum = static_cast<double>(c[0]) + c[1] + c[2] + c[3];
    const double sign = seeds.label[t] == seed_inside ? 1 : -1;
    const bool hint = !seeds.hint.empty() && seeds.hint[t];
    problem.preference[t] =
        static_cast<std::int64_t>(sign * std::floor((hint ? hint_trust : seed_trust) * sum));
  });
  return problem;
}

}  // namespace

SurfaceCut cut_surface(const TetMesh& mesh, const EnergyModel& model, const Seeds& seeds,
                       const std::vector<double>& curvature, Job& job) {
  SurfaceCut cut;
  const CutProblem problem = make_problem(mesh, model, seeds, curvature, job.threads());
  job.tick(0.3);
  ContractedCut contracted = contract(mesh, problem, job);
  cut.free = contracted.tetrahedron.size();
  const MinCut minimum = max_flow(std::move(contracted.graph), job);
  cut.labels = scatter(problem.seed, contracted.tetrahedron, minimum.source_side);
  if (minimum.flow + contracted.constant != labelling_cost(mesh, problem, cut.labels))
    throw Failure(ErrorCode::internal, "the flow and the capacity of the cut differ",
                  "please report it with the input");
  cut.energy = surface_cost(mesh, model, curvature, cut.labels);
  return cut;
}

}  // namespace arris
