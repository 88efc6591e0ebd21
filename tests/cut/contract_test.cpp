#include "cut/contract.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/failure.h"
#include "cut/flow_oracle.h"

namespace arris {
namespace {

// Larger than any sum of capacities here: what ties a seed to its terminal when nothing is
// contracted.
constexpr std::int64_t unbreakable = std::int64_t{1} << 50;

CutProblem random_problem(const TetMesh& mesh, double free_share, bool preferences,
                          std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::uniform_int_distribution<std::int32_t> capacity(0, 500), preference(-400, 400);
  CutProblem problem;
  problem.seed.resize(mesh.size());
  problem.capacity.resize(mesh.size());
  if (preferences) problem.preference.resize(mesh.size());
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    problem.seed[t] = unit(random) < free_share ? seed_free
                      : unit(random) < 0.5      ? seed_inside
                                                : seed_outside;
    for (std::int32_t& c : problem.capacity[t]) c = capacity(random);
    if (preferences) problem.preference[t] = preference(random);
  }
  return problem;
}

// The same problem with all tetrahedra as nodes; its cost is the cut's plus `constant`.
FlowGraph uncontracted(const TetMesh& mesh, const CutProblem& problem) {
  FlowGraph graph;
  graph.neighbours = mesh.neighbours;
  graph.capacity = problem.capacity;
  graph.terminal = problem.preference;
  graph.terminal.resize(mesh.size(), 0);
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    if (problem.seed[t] == seed_inside) graph.terminal[t] += unbreakable;
    if (problem.seed[t] == seed_outside) graph.terminal[t] -= unbreakable;
  }
  return graph;
}

struct Solved {
  Labels labels;
  std::int64_t cost = 0;
};

Solved solve_contracted(const TetMesh& mesh, const CutProblem& problem, unsigned threads = 1) {
  Context context;
  context.threads = threads;
  Job job(context);
  job.stage("cut", 1);
  const ContractedCut contracted = contract(mesh, problem, job);
  const MinCut cut = max_flow(contracted.graph, job);
  return {scatter(problem.seed, contracted.tetrahedron, cut.source_side),
          cut.flow + contracted.constant};
}

TEST(Contract, KeepsTheMinimumOfTheWholeProblem) {
  for (const bool preferences : {false, true})
    for (const double free_share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      const TetMesh mesh = random_tetrahedra(300, free_share > 0.4, 17);
      const CutProblem problem = random_problem(mesh, free_share, preferences, 19);
      const MinCut whole = oracle_max_flow(uncontracted(mesh, problem));
      const Solved solved = solve_contracted(mesh, problem);
      EXPECT_TRUE(solved.labels == whole.source_side);
      EXPECT_EQ(solved.cost, labelling_cost(mesh, problem, solved.labels));
    }
}

TEST(Contract, CutValuePlusConstantIsTheCutOfTheWholeProblem) {
  // Without preferences of the seeds themselves the uncontracted cut has no constant of its own.
  const TetMesh mesh = random_tetrahedra(400, true, 23);
  const CutProblem problem = random_problem(mesh, 0.6, false, 29);
  const FlowGraph whole = uncontracted(mesh, problem);
  const Solved solved = solve_contracted(mesh, problem);
  EXPECT_EQ(solved.cost, oracle_max_flow(whole).flow);
  EXPECT_EQ(solved.cost, cut_capacity(whole, solved.labels));
}

RC_GTEST_PROP(Contract, EveryLabellingCostsItsCutPlusTheConstant, ()) {
  static const TetMesh mesh = random_tetrahedra(60, false, 31);
  const double free_share = *rc::gen::element(0.2, 0.7, 1.0);
  const CutProblem problem = random_problem(mesh, free_share, *rc::gen::arbitrary<bool>(),
                                            *rc::gen::arbitrary<unsigned>());
  const Context context;
  Job job(context);
  const ContractedCut contracted = contract(mesh, problem, job);
  const auto side = *rc::gen::container<std::vector<std::uint8_t>>(
      contracted.tetrahedron.size(), rc::gen::inRange<std::uint8_t>(0, 2));
  const Labels labels = scatter(problem.seed, contracted.tetrahedron, side);
  RC_ASSERT(labelling_cost(mesh, problem, labels) ==
            cut_capacity(contracted.graph, side) + contracted.constant);
}

TEST(Contract, DoesNotDependOnTheThreads) {
  const TetMesh mesh = random_tetrahedra(5000, false, 37);  // several chunks
  const CutProblem problem = random_problem(mesh, 0.5, true, 41);
  const Solved one = solve_contracted(mesh, problem, 1), four = solve_contracted(mesh, problem, 4);
  EXPECT_EQ(one.cost, four.cost);
  EXPECT_TRUE(one.labels == four.labels);
}

TEST(Contract, RefusesSizesThatDoNotMatch) {
  const TetMesh mesh = random_tetrahedra(20, false, 43);
  CutProblem problem = random_problem(mesh, 0.5, false, 47);
  problem.seed.pop_back();
  const Context context;
  Job job(context);
  try {
    contract(mesh, problem, job);
    FAIL();
  } catch (const Failure& f) {
    EXPECT_EQ(f.error().code, ErrorCode::internal);
  }
}

}  // namespace
}  // namespace arris
