#include "cut/max_flow.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include "base/failure.h"
#include "cut/flow_oracle.h"

namespace arris {
namespace {

MinCut solve(const FlowGraph& graph) {
  const Context context;
  Job job(context);
  job.stage("cut", 1);
  return max_flow(graph, job);
}

ErrorCode refusal(const FlowGraph& graph) {
  try {
    solve(graph);
  } catch (const Failure& f) {
    return f.error().code;
  }
  return ErrorCode::usage;  // not a refusal of max_flow
}

// The dual graph of all tetrahedra with random capacities and terminals.
FlowGraph dual_graph(const TetMesh& mesh, double terminal_share, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<std::int32_t> capacity(0, 1000), terminal(-3000, 3000);
  std::uniform_real_distribution<double> unit(0, 1);
  FlowGraph graph;
  graph.neighbours = mesh.neighbours;
  graph.capacity.resize(mesh.size());
  graph.terminal.assign(mesh.size(), 0);
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    for (std::int32_t& c : graph.capacity[t]) c = capacity(random);
    if (unit(random) < terminal_share) graph.terminal[t] = terminal(random);
  }
  return graph;
}

void expect_like_oracle(const FlowGraph& graph) {
  const MinCut cut = solve(graph), oracle = oracle_max_flow(graph);
  EXPECT_EQ(cut.flow, oracle.flow);
  EXPECT_EQ(cut.flow, cut_capacity(graph, cut.source_side));
  EXPECT_TRUE(cut.source_side == oracle.source_side);
}

RC_GTEST_PROP(MaxFlow, MatchesTheOracleOnRandomGraphs, ()) {
  RandomGraph d;
  d.nodes = *rc::gen::inRange<std::uint32_t>(1, 200);
  d.density = *rc::gen::element(0.2, 0.5, 0.9, 1.0);  // below a half: many components
  d.zero_share = *rc::gen::element(0.0, 0.3, 0.9, 1.0);
  d.terminal_share = *rc::gen::element(0.0, 0.02, 0.2, 1.0);
  d.largest = *rc::gen::element<std::int32_t>(1, 3, 100, max_arc_capacity);
  d.seed = *rc::gen::arbitrary<std::uint64_t>();
  const FlowGraph graph = random_flow_graph(d);
  const MinCut cut = solve(graph), oracle = oracle_max_flow(graph);
  RC_ASSERT(cut.flow == oracle.flow);
  RC_ASSERT(cut.flow == cut_capacity(graph, cut.source_side));
  RC_ASSERT(cut.source_side == oracle.source_side);
}

// Few terminals far apart: long paths, and trees that are torn and joined often.
RC_GTEST_PROP(MaxFlow, MatchesTheOracleOnLongPaths, ()) {
  const auto length = *rc::gen::inRange<std::uint32_t>(2, 60);
  const auto rows = *rc::gen::inRange<std::uint32_t>(1, 6);
  FlowGraph graph;
  graph.neighbours.assign(length * rows, {no_node, no_node, no_node, no_node});
  graph.capacity.resize(length * rows);
  graph.terminal.assign(length * rows, 0);
  for (std::uint32_t n = 0; n < length * rows; ++n) {
    const std::uint32_t x = n % length, y = n / length;
    if (x > 0) graph.neighbours[n][0] = n - 1;
    if (x + 1 < length) graph.neighbours[n][1] = n + 1;
    if (y > 0) graph.neighbours[n][2] = n - length;
    if (y + 1 < rows) graph.neighbours[n][3] = n + length;
    for (std::int32_t& c : graph.capacity[n]) c = *rc::gen::inRange(0, 20);
    if (x == 0) graph.terminal[n] = *rc::gen::inRange(0, 40);
    if (x + 1 == length) graph.terminal[n] = -*rc::gen::inRange(0, 40);
  }
  const MinCut cut = solve(graph), oracle = oracle_max_flow(graph);
  RC_ASSERT(cut.flow == oracle.flow);
  RC_ASSERT(cut.source_side == oracle.source_side);
}

TEST(MaxFlow, MatchesTheOracleOnDelaunayGraphs) {
  for (const bool near_sphere : {false, true})
    for (const double terminal_share : {0.002, 0.05, 1.0}) {
      const TetMesh mesh = random_tetrahedra(1500, near_sphere, 7);
      expect_like_oracle(dual_graph(mesh, terminal_share, 11));
    }
}

TEST(MaxFlow, EmptyGraph) {
  const MinCut cut = solve({});
  EXPECT_EQ(cut.flow, 0);
  EXPECT_TRUE(cut.source_side.empty());
}

TEST(MaxFlow, SingleNodes) {
  for (const std::int64_t terminal : {-5, 0, 5}) {
    FlowGraph graph;
    graph.neighbours.push_back({no_node, no_node, no_node, no_node});
    graph.capacity.push_back({1, 2, 3, 4});  // of arcs that are not there
    graph.terminal.push_back(terminal);
    const MinCut cut = solve(graph);
    EXPECT_EQ(cut.flow, 0);
    EXPECT_EQ(cut.source_side[0], terminal > 0);
  }
}

// Every node of a cycle gives or takes more than 32 bits hold, and every arc is as wide as allowed.
TEST(MaxFlow, CapacitiesAtTheLimit) {
  constexpr std::uint32_t n = 1000;
  constexpr std::int64_t huge = std::int64_t{1} << 40;
  FlowGraph graph;
  for (std::uint32_t v = 0; v < n; ++v) {
    graph.neighbours.push_back({(v + 1) % n, (v + n - 1) % n, no_node, no_node});
    graph.capacity.push_back({max_arc_capacity, max_arc_capacity, 0, 0});
    graph.terminal.push_back(v % 4 < 2 ? huge : -huge);
  }
  expect_like_oracle(graph);
  EXPECT_EQ(solve(graph).flow, std::int64_t{n / 2} * max_arc_capacity);
}

TEST(MaxFlow, TiesGoToTheSmallestSourceSide) {
  // source -5-> 0 -5-> 1 -5-> 2 -5-> sink: every arc is a minimum cut.
  FlowGraph graph;
  graph.neighbours = {
      {1, no_node, no_node, no_node}, {0, 2, no_node, no_node}, {1, no_node, no_node, no_node}};
  graph.capacity = {{5, 0, 0, 0}, {0, 5, 0, 0}, {0, 0, 0, 0}};
  graph.terminal = {5, 0, -5};
  const MinCut cut = solve(graph);
  EXPECT_EQ(cut.flow, 5);
  EXPECT_EQ(cut.source_side, (std::vector<std::uint8_t>{0, 0, 0}));
}

TEST(MaxFlow, IsDeterministic) {
  const FlowGraph graph = dual_graph(random_tetrahedra(1000, false, 3), 0.3, 5);
  const MinCut a = solve(graph), b = solve(graph);
  EXPECT_EQ(a.flow, b.flow);
  EXPECT_TRUE(a.source_side == b.source_side);
}

TEST(MaxFlow, StopsOnRequest) {
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  Job job(context);
  const FlowGraph graph = dual_graph(random_tetrahedra(200, false, 3), 0.3, 5);
  try {
    max_flow(graph, job);
    FAIL();
  } catch (const Failure& f) {
    EXPECT_EQ(f.error().code, ErrorCode::cancelled);
  }
}

TEST(MaxFlow, StopsInTheMiddleAndTellsProgress) {
  std::atomic<bool> cancel{false};
  std::vector<double> told;
  Context context;
  context.cancel = &cancel;
  context.progress = [&](std::string_view, double fraction) {
    told.push_back(fraction);
    cancel = told.size() > 1;  // the first is told by the stage itself
  };
  Job job(context);
  job.stage("cut", 1);
  const FlowGraph graph = dual_graph(random_tetrahedra(20000, false, 3), 0.3, 5);
  const auto until_cancelled = [&] {
    while (true) max_flow(graph, job);
  };
  EXPECT_THROW(until_cancelled(), Failure);
  EXPECT_EQ(told.size(), 2u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
}

TEST(MaxFlow, RefusesBrokenGraphs) {
  FlowGraph good;
  good.neighbours = {{1, no_node, no_node, no_node}, {0, no_node, no_node, no_node}};
  good.capacity = {{5, 0, 0, 0}, {5, 0, 0, 0}};
  good.terminal = {1, -1};
  EXPECT_EQ(solve(good).flow, 1);

  FlowGraph broken = good;
  broken.neighbours[1][0] = no_node;
  EXPECT_EQ(refusal(broken), ErrorCode::internal);
  broken = good;
  broken.neighbours[0][0] = 2;
  EXPECT_EQ(refusal(broken), ErrorCode::internal);
  broken = good;
  broken.capacity[0][0] = max_arc_capacity + 1;
  EXPECT_EQ(refusal(broken), ErrorCode::internal);
  broken = good;
  broken.capacity[0][0] = -1;
  EXPECT_EQ(refusal(broken), ErrorCode::internal);
  broken = good;
  broken.terminal.pop_back();
  EXPECT_EQ(refusal(broken), ErrorCode::internal);
}

}  // namespace
}  // namespace arris
