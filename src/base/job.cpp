#include "base/job.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "base/failure.h"
#include "base/parallel.h"

namespace arris {

std::uint64_t peak_memory() noexcept {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux reports KiB
}

std::uint64_t machine_memory() noexcept {
  const auto pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
  std::uint64_t bytes = pages > 0 && page > 0
                            ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page)
                            : 0;
  std::uint64_t group = 0;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> group && group > 0)
    bytes = bytes == 0 ? group : std::min(bytes, group);
  return bytes;
}

Job::Job(const Context& context) : context_(context), threads_(resolve_threads(context.threads)) {}

void Job::stage(std::string name, double share) {
  end_stage();
  stages_.push_back({std::move(name), 0, 0});
  share_ = share;
  stage_start_ = Clock::now();
  running_ = true;
  tell(0, true);
}

void Job::finish() {
  end_stage();
  done_ = 1;  // whatever stages were left out
  if (!stages_.empty()) tell(1, true);
}

void Job::tick(double fraction) {
  tell(fraction, false);
}

bool Job::cancelled() const noexcept {
  return context_.cancel && context_.cancel->load(std::memory_order_relaxed);
}

void Job::end_stage() {
  if (!running_) return;
  stages_.back().seconds = std::chrono::duration<double>(Clock::now() - stage_start_).count();
  stages_.back().peak_memory = peak_memory();
  done_ = std::min(1.0, done_ + share_);
  share_ = 0;
  running_ = false;
}

void Job::tell(double fraction, bool always) {
  if (cancelled())
    throw Failure(ErrorCode::cancelled, "stopped on request", "run it again to get a result");
  if (!context_.progress) return;
  const auto now = Clock::now();
  if (!always && now - last_told_ < std::chrono::milliseconds(100)) return;
  last_told_ = now;
  highest_ = std::max(highest_, std::min(1.0, done_ + share_ * std::clamp(fraction, 0.0, 1.0)));
  context_.progress(stages_.back().name, highest_);
}

}  // namespace arris
