// The algorithms that src/cut/max_flow.cpp was chosen among: same contract as max_flow.
#pragma once

#include "cut/max_flow.h"

namespace arris {

// Y. Boykov, V. Kolmogorov, "An experimental comparison of min-cut/max-flow algorithms for energy
// minimization in vision", PAMI 2004: two trees that keep growing, no bound on path length.
MinCut boykov_kolmogorov(FlowGraph graph, Job& job);

// A. Goldberg, R. Tarjan, "A new approach to the maximum-flow problem", JACM 1988; B. Cherkassky,
// A. Goldberg, "On implementing push-relabel method for the maximum flow problem", Algorithmica
// 1997: highest label, gaps, global relabelling; first phase only, from the sink, so that it ends
// with the smallest source side.
MinCut push_relabel(FlowGraph graph, Job& job);

}  // namespace arris
