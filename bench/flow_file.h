// Flow graphs in files, so that graphs of the real pipeline can be kept and solved again.
#pragma once

#include <string>

#include "cut/max_flow.h"

namespace arris {

// The format, all integers little endian: the 8 bytes "ARRISFG1"; n as uint64; then the three
// arrays of FlowGraph as they are: n x 4 uint32 neighbours (0xFFFFFFFF: none), n x 4 int32
// capacities, n int64 terminals. Both throw std::runtime_error with the path.
void dump_flow_graph(const std::string& path, const FlowGraph& graph);
FlowGraph load_flow_graph(const std::string& path);

}  // namespace arris
