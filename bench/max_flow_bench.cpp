// Times the maximum-flow algorithms on dual graphs of tetrahedra.
//   max_flow_bench [samples [part]]           made scenes, contracted, of which the name contains
//                                             `part`; 10000 samples each if not said
//   max_flow_bench --graph file...            graphs that dump_flow_graph wrote
//   max_flow_bench --dump dir samples [part]  writes the made graphs
// With --algorithms "names" before all others, only those run. Each row: nodes, arcs, processor
// seconds (median of three, construction of the residual graph included), flow.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <string>

#include "flow_algorithms.h"
#include "flow_file.h"
#include "flow_graphs.h"

namespace arris {
namespace {

struct Algorithm {
  const char* name;
  MinCut (*solve)(FlowGraph, Job&);
};
constexpr Algorithm algorithms[] = {
    {"max_flow", max_flow}, {"ibfs", incremental_bfs}, {"push_relabel", push_relabel}};

std::size_t arcs(const FlowGraph& graph) {
  std::size_t count = 0;
  for (const auto& neighbours : graph.neighbours)
    for (const std::uint32_t n : neighbours) count += n != no_node;
  return count;
}

// Solves it three times with each algorithm and prints a row each; false if any two disagree.
bool compare(const std::string& name, const FlowGraph& graph, const std::string& which, Job& job) {
  MinCut first;
  bool good = true;
  for (const Algorithm& algorithm : algorithms) {
    std::array<double, 3> seconds{};
    MinCut cut;
    if (which.find(algorithm.name) == std::string::npos) continue;
    for (double& s : seconds) {
      FlowGraph copy = graph;
      const std::clock_t start = std::clock();
      cut = algorithm.solve(std::move(copy), job);
      s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    }
    std::sort(seconds.begin(), seconds.end());
    if (first.source_side.empty()) first = cut;
    const bool agrees = cut.flow == first.flow && cut.source_side == first.source_side &&
                        cut.flow == cut_capacity(graph, cut.source_side);
    good = good && agrees;
    std::printf("%-26s %9zu %9zu  %-13s %8.3f  %lld%s\n", name.c_str(), graph.terminal.size(),
                arcs(graph), algorithm.name, seconds[1], static_cast<long long>(cut.flow),
                agrees ? "" : "  DISAGREES");
    std::fflush(stdout);
  }
  return good;
}

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  for (const Terminals terminals : {Terminals::hard, Terminals::sparse, Terminals::soft})
    for (const Shape shape : {Shape::bumpy_sphere, Shape::torus, Shape::box_with_holes})
      for (const Flaw flaw : {Flaw::none, Flaw::noise, Flaw::outliers})
        all.push_back({shape, flaw, terminals});
  return all;
}

bool run(int argc, char** argv) {
  const Context context;
  Job job(context);
  job.stage("bench", 1);
  bool good = true;
  std::string which = "max_flow ibfs push_relabel";
  if (argc > 2 && std::strcmp(argv[1], "--algorithms") == 0) {
    which = argv[2];
    argc -= 2;
    argv += 2;
  }
  if (argc > 2 && std::strcmp(argv[1], "--graph") == 0) {
    for (int k = 2; k < argc; ++k)
      good = compare(argv[k], load_flow_graph(argv[k]), which, job) && good;
    return good;
  }
  const bool dump = argc > 3 && std::strcmp(argv[1], "--dump") == 0;
  const int first = dump ? 3 : 1;  // of the arguments both have
  const std::string count = argc > first ? argv[first] : "10000";
  const std::string only = argc > first + 1 ? argv[first + 1] : "";
  for (const Scene& scene : scenes()) {
    if (name(scene).find(only) == std::string::npos) continue;
    const SceneCut cut = make_scene(scene, std::stoul(count), job);
    const ContractedCut contracted = contract(cut.mesh, cut.problem, job);
    std::string label = name(scene) + "/" + count;
    if (!dump) {
      good = compare(label, contracted.graph, which, job) && good;
      continue;
    }
    std::replace(label.begin(), label.end(), '/', '-');
    dump_flow_graph(std::string(argv[2]) + "/" + label, contracted.graph);
  }
  return good;
}

}  // namespace
}  // namespace arris

int main(int argc, char** argv) {
  try {
    return arris::run(argc, argv) ? 0 : 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
  }
}
