#include "base/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <latch>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/failure.h"
#include "base/job.h"

namespace arris {
namespace {

using Range = std::pair<std::size_t, std::size_t>;

std::vector<Range> chunks_of(std::size_t n, std::size_t grain, unsigned threads) {
  std::vector<Range> seen;
  std::mutex mutex;
  parallel_chunks(n, grain, threads, [&](std::size_t begin, std::size_t end) {
    const std::lock_guard lock(mutex);
    seen.emplace_back(begin, end);
  });
  std::sort(seen.begin(), seen.end());
  return seen;
}

TEST(Parallel, ChunksDependOnTheSizeAlone) {
  const std::vector<Range> expected = {{0, 7}, {7, 14}, {14, 20}};
  for (const unsigned threads : {0u, 1u, 2u, 9u}) {
    EXPECT_EQ(chunks_of(20, 7, threads), expected);
    EXPECT_EQ(chunks_of(6, 7, threads), (std::vector<Range>{{0, 6}}));
    EXPECT_TRUE(chunks_of(0, 7, threads).empty());
  }
}

TEST(Parallel, RunsOnAsManyThreadsAsAsked) {
  constexpr unsigned threads = 2;
  std::latch all_here(threads);  // one thread alone would wait for ever
  parallel_chunks(threads, 1, threads,
                  [&](std::size_t, std::size_t) { all_here.arrive_and_wait(); });
  EXPECT_TRUE(all_here.try_wait());
}

TEST(Parallel, VisitsEveryElementOnce) {
  std::vector<int> visits(100'001, 0);  // many chunks
  parallel_for(visits.size(), 2, [&](std::size_t i) { ++visits[i]; });
  EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), 100'001);
}

TEST(Parallel, SumsHaveTheSameBitsForAnyNumberOfThreads) {
  const auto value = [](std::size_t i) { return std::sin(static_cast<double>(i)) * 1e3; };
  const double one = parallel_sum(100'001, 1, value);
  double naive = 0;
  for (std::size_t i = 0; i < 100'001; ++i) naive += value(i);
  EXPECT_NEAR(one, naive, 1e-6);
  for (const unsigned threads : {2u, 3u, 8u}) EXPECT_EQ(parallel_sum(100'001, threads, value), one);
}

TEST(Parallel, AnExceptionComesOutAfterAllThreadsStopped) {
  for (const unsigned threads : {1u, 2u, 5u}) {
    std::atomic<int> running{0};
    const auto body = [&](std::size_t begin, std::size_t) {
      ++running;
      const bool fails = begin == 30;
      --running;
      if (fails) throw std::runtime_error("chunk 30");
    };
    EXPECT_THROW(parallel_chunks(100, 1, threads, body), std::runtime_error);
    EXPECT_EQ(running, 0);
  }
}

TEST(Parallel, AJobHearsHowFarItIsBetweenBatches) {
  Context context;
  context.threads = 2;
  std::vector<double> heard;
  context.progress = [&](std::string_view, double fraction) { heard.push_back(fraction); };
  Job job(context);
  job.stage("chunks", 1);
  std::vector<int> visits(1001, 0);
  parallel_chunks(visits.size(), 3, job, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++visits[i];
  });
  EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), 1001);
  EXPECT_FALSE(heard.empty());
  EXPECT_TRUE(std::is_sorted(heard.begin(), heard.end()));
}

TEST(Parallel, AJobCanBeCancelledBetweenBatches) {
  std::atomic<bool> cancel = false;
  Context context;
  context.threads = 1;
  context.cancel = &cancel;
  Job job(context);
  job.stage("chunks", 1);
  std::size_t visited = 0;
  const auto body = [&](std::size_t begin, std::size_t end) {
    visited += end - begin;
    cancel = true;
  };
  EXPECT_THROW(parallel_chunks(1'000'000, 1, job, body), Failure);
  EXPECT_GT(visited, 0u);
  EXPECT_LT(visited, 1000u);
}

TEST(Parallel, ZeroThreadsMeansOnePerProcessor) {
  EXPECT_GE(resolve_threads(0), 1u);
  EXPECT_EQ(resolve_threads(3), 3u);
  EXPECT_LE(resolve_threads(4'000'000'000u), 256u);
}

}  // namespace
}  // namespace arris
