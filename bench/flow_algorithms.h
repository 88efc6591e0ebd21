// The algorithms that src/cut/max_flow.cpp was chosen among: same contract as max_flow.
#pragma once

#include "cut/max_flow.h"

namespace arris {

// A. Goldberg, S. Hed, H. Kaplan, R. Tarjan, R. Werneck, "Maximum flows by incremental
// breadth-first search", ESA 2011: two trees of shortest paths that grow level by level; the
// shallower one first, orphans by distance.
MinCut incremental_bfs(FlowGraph graph, Job& job);

// A. Goldberg, R. Tarjan, "A new approach to the maximum-flow problem", JACM 1988; B. Cherkassky,
// A. Goldberg, "On implementing push-relabel method for the maximum flow problem", Algorithmica
// 1997: highest label, gaps, global relabelling; first phase only, from the sink, so that it ends
// with the smallest source side.
MinCut push_relabel(FlowGraph graph, Job& job);

}  // namespace arris
