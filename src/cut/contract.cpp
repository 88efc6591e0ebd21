#include "cut/contract.h"

#include <algorithm>
#include <atomic>

#include "base/failure.h"
#include "base/parallel.h"

namespace arris {
namespace {

constexpr std::size_t grain = 8192;  // tetrahedra a chunk: enough that handing it out costs nothing

void require_matching_sizes(const TetMesh& mesh, const CutProblem& problem) {
  if (problem.seed.size() != mesh.size() || problem.capacity.size() != mesh.size() ||
      (!problem.preference.empty() && problem.preference.size() != mesh.size()))
    throw Failure(ErrorCode::internal, "the cut problem does not match its tetrahedra",
                  "please report it with the input");
}

std::int64_t preference_of(const CutProblem& problem, std::size_t t) {
  return problem.preference.empty() ? 0 : problem.preference[t];
}

// The node of every tetrahedron, no_node for those with a known label.
std::vector<std::uint32_t> number_free(const std::vector<Seed>& seed,
                                       std::vector<Tet>& tetrahedron) {
  std::vector<std::uint32_t> node(seed.size(), no_node);
  tetrahedron.reserve(static_cast<std::size_t>(std::count(seed.begin(), seed.end(), seed_free)));
  for (std::size_t t = 0; t < seed.size(); ++t) {
    if (seed[t] != seed_free) continue;
    node[t] = static_cast<std::uint32_t>(tetrahedron.size());
    tetrahedron.push_back(static_cast<Tet>(t));
  }
  return node;
}

// What a tetrahedron with a known label costs whatever the cut does.
std::int64_t known_cost(const TetMesh& mesh, const CutProblem& problem, std::size_t t) {
  const std::int64_t preference = preference_of(problem, t);
  if (problem.seed[t] == seed_outside) return std::max<std::int64_t>(preference, 0);
  std::int64_t cost = std::max<std::int64_t>(-preference, 0);
  for (std::size_t i = 0; i < 4; ++i)
    if (problem.seed[mesh.neighbours[t][i]] == seed_outside) cost += problem.capacity[t][i];
  return cost;
}

// Fills the arcs and the terminal of the node of t; returns its unavoidable cost.
std::int64_t fill_node(const TetMesh& mesh, const CutProblem& problem,
                       const std::vector<std::uint32_t>& node, Tet t, FlowGraph& graph) {
  const std::uint32_t n = node[t];
  const std::int64_t preference = preference_of(problem, t);
  std::int64_t from_source = std::max<std::int64_t>(preference, 0);
  std::int64_t to_sink = std::max<std::int64_t>(-preference, 0);
  for (std::size_t i = 0; i < 4; ++i) {
    const Tet u = mesh.neighbours[t][i];
    const bool free = problem.seed[u] == seed_free;
    graph.neighbours[n][i] = node[u];
    graph.capacity[n][i] = free ? problem.capacity[t][i] : 0;
    if (problem.seed[u] == seed_outside) to_sink += problem.capacity[t][i];
    if (problem.seed[u] == seed_inside)
      from_source += problem.capacity[u][static_cast<std::size_t>(mesh.facet_to(u, t))];
  }
  graph.terminal[n] = from_source - to_sink;
  return std::min(from_source, to_sink);
}

}  // namespace

ContractedCut contract(const TetMesh& mesh, const CutProblem& problem, Job& job) {
  require_matching_sizes(mesh, problem);
  ContractedCut result;
  const std::vector<std::uint32_t> node = number_free(problem.seed, result.tetrahedron);
  job.tick(0);
  result.graph.neighbours.resize(result.tetrahedron.size());
  result.graph.capacity.resize(result.tetrahedron.size());
  result.graph.terminal.resize(result.tetrahedron.size());
  std::atomic<std::int64_t> constant{0};  // a sum of integers: the same in any order
  parallel_chunks(mesh.size(), grain, job.threads(), [&](std::size_t begin, std::size_t end) {
    std::int64_t sum = 0;
    for (std::size_t t = begin; t < end; ++t)
      sum += problem.seed[t] == seed_free
                 ? fill_node(mesh, problem, node, static_cast<Tet>(t), result.graph)
                 : known_cost(mesh, problem, t);
    constant += sum;
  });
  result.constant = constant;
  job.tick(1);
  return result;
}

Labels scatter(const std::vector<Seed>& seed, const std::vector<Tet>& tetrahedron,
               const std::vector<std::uint8_t>& source_side) {
  Labels labels(seed.size());
  std::transform(seed.begin(), seed.end(), labels.begin(),
                 [](Seed s) { return static_cast<std::uint8_t>(s == seed_inside); });
  for (std::size_t n = 0; n < tetrahedron.size(); ++n) labels[tetrahedron[n]] = source_side[n];
  return labels;
}

std::int64_t labelling_cost(const TetMesh& mesh, const CutProblem& problem, const Labels& labels) {
  std::int64_t cost = 0;
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    const std::int64_t preference = preference_of(problem, t);
    cost += std::max<std::int64_t>(labels[t] ? -preference : preference, 0);
    if (!labels[t]) continue;
    for (std::size_t i = 0; i < 4; ++i)
      if (!labels[mesh.neighbours[t][i]]) cost += problem.capacity[t][i];
  }
  return cost;
}

}  // namespace arris
