#include "cut/flow_oracle.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/push_relabel_max_flow.hpp>
#include <numeric>

#include "base/vec.h"
#include "tetra/delaunay.h"

namespace arris {
namespace {

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using BoostGraph = boost::adjacency_list<
    boost::vecS, boost::vecS, boost::directedS, boost::no_property,
    boost::property<
        boost::edge_capacity_t, std::int64_t,
        boost::property<boost::edge_residual_capacity_t, std::int64_t,
                        boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>>;

void add_arc(BoostGraph& g, std::size_t from, std::size_t to, std::int64_t capacity) {
  const auto arc = add_edge(from, to, g).first, back = add_edge(to, from, g).first;
  put(boost::edge_capacity, g, arc, capacity);
  put(boost::edge_capacity, g, back, 0);
  put(boost::edge_reverse, g, arc, back);
  put(boost::edge_reverse, g, back, arc);
}

std::vector<std::uint8_t> reachable(const BoostGraph& g, std::size_t source) {
  std::vector<std::uint8_t> seen(num_vertices(g), 0);
  std::vector<std::size_t> queue = {source};
  seen[source] = 1;
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const auto [begin, end] = out_edges(queue[k], g);
    for (auto arc = begin; arc != end; ++arc) {
      const std::size_t to = target(*arc, g);
      if (seen[to] || get(boost::edge_residual_capacity, g, *arc) == 0) continue;
      seen[to] = 1;
      queue.push_back(to);
    }
  }
  return seen;
}

}  // namespace

MinCut oracle_max_flow(const FlowGraph& graph) {
  const std::size_t n = graph.terminal.size(), source = n, sink = n + 1;
  BoostGraph g(n + 2);
  for (std::size_t v = 0; v < n; ++v) {
    if (graph.terminal[v] > 0) add_arc(g, source, v, graph.terminal[v]);
    if (graph.terminal[v] < 0) add_arc(g, v, sink, -graph.terminal[v]);
    for (std::size_t i = 0; i < 4; ++i)
      if (graph.neighbours[v][i] != no_node)
        add_arc(g, v, graph.neighbours[v][i], graph.capacity[v][i]);
  }
  MinCut cut;
  cut.flow = push_relabel_max_flow(g, source, sink);
  cut.source_side = reachable(g, source);
  cut.source_side.resize(n);
  return cut;
}

FlowGraph random_flow_graph(const RandomGraph& d) {
  std::mt19937_64 random(d.seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto amount = [&] {
    return unit(random) < d.zero_share
               ? 0
               : std::uniform_int_distribution<std::int32_t>(0, d.largest)(random);
  };
  FlowGraph graph;
  graph.neighbours.assign(d.nodes, {no_node, no_node, no_node, no_node});
  graph.capacity.assign(d.nodes, {});
  graph.terminal.assign(d.nodes, 0);
  // Four times a random pairing: node 2k with node 2k + 1 of a shuffle, each in its slot i.
  std::vector<std::uint32_t> order(d.nodes);
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t i = 0; i < 4; ++i) {
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t k = 0; k + 1 < d.nodes; k += 2) {
      const std::uint32_t a = order[k], b = order[k + 1];
      const auto& known = graph.neighbours[a];
      if (unit(random) >= d.density || std::find(known.begin(), known.end(), b) != known.end())
        continue;
      const std::size_t j = static_cast<std::size_t>(
          std::find(graph.neighbours[b].begin(), graph.neighbours[b].end(), no_node) -
          graph.neighbours[b].begin());  // not always i: sisters must not rely on it
      graph.neighbours[a][i] = b;
      graph.neighbours[b][j] = a;
      graph.capacity[a][i] = amount();
      graph.capacity[b][j] = amount();
    }
  }
  for (std::int64_t& t : graph.terminal)
    if (unit(random) < d.terminal_share) t = std::int64_t{amount()} - amount();
  return graph;
}

TetMesh random_tetrahedra(std::size_t points, bool near_sphere, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Vec3> positions(points);
  for (Vec3& p : positions) {
    p = {unit(random), unit(random), unit(random)};
    if (near_sphere) p = (1 + 0.02 * unit(random)) / length(p) * p;
  }
  std::sort(positions.begin(), positions.end(), lexicographic_less);
  const Context context;
  Job job(context);
  job.stage("delaunay", 1);
  return delaunay(positions, points, job);
}

}  // namespace arris
