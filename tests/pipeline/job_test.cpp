// How a reconstruction runs: progress, cancellation, memory, options.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <set>
#include <string>

#include "pipeline/clouds.h"

namespace arris {
namespace {

using namespace test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

struct Tick {
  std::string stage;
  double fraction;
};

std::vector<Tick> ticks_of(const PointCloud& cloud, const Options& options) {
  std::vector<Tick> ticks;
  Context context;
  context.progress = [&](std::string_view stage, double fraction) {
    ticks.push_back({std::string(stage), fraction});
  };
  const Result<Reconstruction> r = reconstruct(cloud, options, context);
  EXPECT_TRUE(r) << said(r);
  return ticks;
}

TEST(Progress, NeverDecreasesAndEndsAtOne) {
  Options two_cycles = paper();
  two_cycles.cycles = 2;
  Options bare;
  bare.swap = false;
  for (const Options& options : {Options{}, paper(), two_cycles, bare}) {
    const std::vector<Tick> ticks = ticks_of(feature_cloud("cube", 400), options);
    ASSERT_FALSE(ticks.empty());
    double last = 0;
    for (const Tick& t : ticks) {
      EXPECT_FALSE(t.stage.empty());
      EXPECT_GE(t.fraction, last) << t.stage;
      last = t.fraction;
    }
    EXPECT_EQ(last, 1);
  }
}

TEST(Progress, ANewStageIsAlwaysTold) {
  std::set<std::string> seen;
  for (const Tick& t : ticks_of(feature_cloud("cube", 400), paper())) seen.insert(t.stage);
  EXPECT_EQ(seen,
            (std::set<std::string>{"samples", "delaunay", "seeds", "background", "cut 1", "cut 2",
                                   "cut 3", "swap", "check", "support", "features"}));
}

// The callback asks to stop when it hears of the stage; `all` is set to the stages heard of.
Result<Reconstruction> cancelled_at(const PointCloud& cloud, const Options& options,
                                    const std::string& at, bool& more) {
  std::atomic<bool> cancel = false;
  more = false;
  Context context;
  context.cancel = &cancel;
  context.progress = [&](std::string_view stage, double) {
    if (cancel && stage != at) more = true;
    if (stage == at) cancel = true;
  };
  return reconstruct(cloud, options, context);
}

TEST(Cancel, FromTheCallbackAtEveryStage) {
  const PointCloud cloud = feature_cloud("cube", 400);
  for (const Options& options : {Options{}, paper()}) {
    std::set<std::string> stages;
    for (const Tick& t : ticks_of(cloud, options)) stages.insert(t.stage);
    for (const std::string& stage : stages) {
      bool more = false;
      const Result<Reconstruction> r = cancelled_at(cloud, options, stage, more);
      EXPECT_EQ(code_of(r), ErrorCode::cancelled) << stage << ": " << said(r);
      EXPECT_FALSE(more) << "work went on after " << stage;
    }
  }
}

TEST(Cancel, BeforeItStarts) {
  const std::atomic<bool> cancel = true;
  Context context;
  context.cancel = &cancel;
  EXPECT_EQ(code_of(reconstruct(feature_cloud("cube", 300), {}, context)), ErrorCode::cancelled);
}

TEST(Memory, ALimitBelowTheForecastIsRefusedBeforeAnyWork) {
  const PointCloud cloud = feature_cloud("cube", 300);
  Context context;
  bool worked = false;
  context.progress = [&](std::string_view, double) { worked = true; };
  context.memory_limit = forecast_memory(cloud.positions.size()) - 1;
  const Result<Reconstruction> r = reconstruct(cloud, {}, context);
  EXPECT_EQ(code_of(r), ErrorCode::out_of_memory);
  EXPECT_FALSE(worked);
  context.memory_limit = forecast_memory(cloud.positions.size());
  EXPECT_TRUE(reconstruct(cloud, {}, context));
}

TEST(Memory, ForecastGrowsWithPointsAndBackground) {
  const std::size_t counts[] = {0, 1, 1000, 1000000, 100000000, 4000000000};
  for (std::size_t k = 1; k < std::size(counts); ++k) {
    EXPECT_LT(forecast_memory(counts[k - 1]), forecast_memory(counts[k]));
    EXPECT_LT(forecast_memory(counts[k]), forecast_memory(counts[k], paper()));
  }
  Options options;
  std::size_t last = 0;
  for (double background : {0.0, 0.5, 1.0, 10.0, 1000.0}) {
    options.background = background;
    const std::size_t bytes = forecast_memory(1000000, options);
    EXPECT_GT(bytes, last);
    last = bytes;
  }
}

void expect_usage(const Options& options, const std::string& name) {
  const Result<Reconstruction> r = reconstruct(feature_cloud("cube", 100), options);
  EXPECT_EQ(code_of(r), ErrorCode::usage) << said(r);
  EXPECT_NE(said(r).find(name), std::string::npos) << said(r);
}

TEST(Usage, OptionsOutOfRangeAreNamed) {
  for (double lambda : {-1e-9, -1.0, nan, inf, -inf}) {
    Options options;
    options.lambda = lambda;
    expect_usage(options, "lambda");
  }
  for (int cycles : {-1, 101, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    Options options;
    options.cycles = cycles;
    expect_usage(options, "cycles");
  }
  for (double background : {1000.001, inf, nan}) {
    Options options;
    options.background = background;
    expect_usage(options, "background");
  }
}

TEST(Usage, TheEndsOfTheRangesWork) {
  const PointCloud cloud = feature_cloud("cube", 150);
  for (double lambda : {0.0, 1e-300, 1e6, 1e300}) {
    Options options;
    options.lambda = lambda;
    const Result<Reconstruction> r = reconstruct(cloud, options);
    EXPECT_TRUE(r) << lambda << " " << said(r);
    options.curvature = Curvature::cotangent;
    const Result<Reconstruction> s = reconstruct(cloud, options);
    EXPECT_TRUE(s) << lambda << " " << said(s);
    options.method = Method::paper;
    const Result<Reconstruction> p = reconstruct(cloud, options);
    EXPECT_TRUE(p || p.error().code == ErrorCode::no_surface) << lambda << " " << said(p);
  }
  Options options;
  options.cycles = 100;
  const Result<Reconstruction> r = reconstruct(cloud, options);
  EXPECT_TRUE(r) << said(r);
  EXPECT_EQ(r->report.cut_energy.size(), 100u);
}

}  // namespace
}  // namespace arris
