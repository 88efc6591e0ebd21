// The running job: stages with their share of the whole, progress, cancellation, time and memory.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "arris/context.h"
#include "arris/report.h"

namespace arris {

// Peak resident memory of the process so far, in bytes.
std::uint64_t peak_memory() noexcept;
// Physical memory of the machine (or of its control group, if smaller), in bytes; 0 if unknown.
std::uint64_t machine_memory() noexcept;

// One per public call. Used from the calling thread only, except cancelled().
class Job {
 public:
  explicit Job(const Context& context);

  // Ends the stage before, if any, and starts one that takes `share` of the whole job (shares of
  // all stages sum to about 1).
  void stage(std::string name, double share);
  // Ends the last stage.
  void finish();

  // Reports that `fraction` in [0, 1] of the stage is done; throws Failure(cancelled) if asked to.
  // Cheap: call it every few thousand elements.
  void tick(double fraction);
  bool cancelled() const noexcept;

  unsigned threads() const noexcept { return threads_; }
  const Context& context() const noexcept { return context_; }
  const std::vector<StageReport>& stages() const noexcept { return stages_; }

 private:
  using Clock = std::chrono::steady_clock;
  void end_stage();
  void tell(double fraction, bool always);

  const Context& context_;
  unsigned threads_;
  std::vector<StageReport> stages_;
  Clock::time_point stage_start_{}, last_told_{};
  double done_ = 0, share_ = 0, highest_ = 0;
  bool running_ = false;
};

}  // namespace arris
