// Minimum cuts by another's hand (Boost), and the graphs to try them on.
#pragma once

#include <random>

#include "cut/max_flow.h"
#include "tetra/tet_mesh.h"

namespace arris {

// Flow by Boost's push_relabel_max_flow; source side by a breadth-first search of its residual.
MinCut oracle_max_flow(const FlowGraph& graph);

// `nodes` nodes with at most four arcs each, in no order of space. Each arc is kept with
// probability `density`; capacities and terminals are drawn from [0, largest], one in
// `zero_share` of them 0.
struct RandomGraph {
  std::uint32_t nodes = 0;
  double density = 1;
  double zero_share = 0.2;
  double terminal_share = 0.5;
  std::int32_t largest = 10;
  std::uint64_t seed = 0;
};
FlowGraph random_flow_graph(const RandomGraph& description);

// Delaunay tetrahedra of random points in a cube, or near a sphere.
TetMesh random_tetrahedra(std::size_t points, bool near_sphere, std::uint64_t seed);

}  // namespace arris
