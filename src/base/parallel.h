// Static-range parallelism: the split of the work depends on its size alone, never on the number
// of threads, so whatever a chunk computes is the same for every thread count.
#pragma once

#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace arris {

class Job;

// Threads to use for a request of `threads` (0: one per processor). At least 1.
unsigned resolve_threads(unsigned threads) noexcept;

// Calls body(begin, end) for consecutive chunks of [0, n) of `grain` elements, on up to `threads`
// threads, the calling one included. Chunks must not write to shared state. An exception of a body
// is rethrown here after all threads have stopped.
void parallel_chunks(std::size_t n, std::size_t grain, unsigned threads,
                     const std::function<void(std::size_t, std::size_t)>& body);

// The same; between batches of chunks `job` hears how far it is, and may cancel.
void parallel_chunks(std::size_t n, std::size_t grain, Job& job,
                     const std::function<void(std::size_t, std::size_t)>& body);

// body(i) for every i in [0, n).
template <class Body>
void parallel_for(std::size_t n, unsigned threads, Body&& body) {
  constexpr std::size_t grain = 8192;  // large enough that handing out a chunk costs nothing
  parallel_chunks(n, grain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

// Sum of value(i) over [0, n): chunk by chunk and then over the chunks in order, so the rounding is
// the same for every thread count.
template <class Value>
double parallel_sum(std::size_t n, unsigned threads, Value&& value) {
  constexpr std::size_t grain = 8192;
  std::vector<double> partial((n + grain - 1) / grain, 0);
  parallel_chunks(n, grain, threads, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += value(i);
    partial[begin / grain] = sum;
  });
  return std::accumulate(partial.begin(), partial.end(), 0.0);
}

}  // namespace arris
