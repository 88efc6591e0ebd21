#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/job.h"

namespace arris {

unsigned resolve_threads(unsigned threads) noexcept {
  if (threads == 0) threads = std::thread::hardware_concurrency();
  return std::clamp(threads, 1u, 256u);
}

void parallel_chunks(std::size_t n, std::size_t grain, unsigned threads,
                     const std::function<void(std::size_t, std::size_t)>& body) {
  if (n == 0) return;
  const std::size_t chunks = (n + grain - 1) / grain;
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  auto work = [&] {
    try {
      for (std::size_t c = next++; c < chunks; c = next++)
        body(c * grain, std::min(n, (c + 1) * grain));
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      next = chunks;
    }
  };
  const std::size_t helpers = std::min<std::size_t>(resolve_threads(threads), chunks) - 1;
  std::vector<std::thread> pool;
  pool.reserve(helpers);
  for (std::size_t t = 0; t < helpers; ++t) {
    try {
      pool.emplace_back(work);
    } catch (const std::system_error&) {
      break;  // no more threads to be had: the calling one does the rest
    }
  }
  work();
  for (std::thread& t : pool) t.join();
  if (failure) std::rethrow_exception(failure);
}

void parallel_chunks(std::size_t n, std::size_t grain, Job& job,
                     const std::function<void(std::size_t, std::size_t)>& body) {
  constexpr std::size_t chunks_per_tick = 64;
  const std::size_t batch = chunks_per_tick * grain;
  for (std::size_t from = 0; from < n; from += batch) {
    job.tick(static_cast<double>(from) / static_cast<double>(n));
    parallel_chunks(std::min(batch, n - from), grain, job.threads(),
                    [&](std::size_t begin, std::size_t end) { body(from + begin, from + end); });
  }
}

}  // namespace arris
