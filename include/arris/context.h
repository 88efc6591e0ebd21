// The execution context: how many threads, how much memory, who listens, and who may stop it.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string_view>

namespace arris {

// Everything about *how* to run; nothing in it changes the result. Copyable. The pointers and the
// callback must outlive the call they are given to.
struct Context {
  // Worker threads; 0 means one per processor. The output bytes do not depend on it.
  unsigned threads = 0;

  // Refuse work whose memory forecast exceeds this many bytes; 0 means the memory of the machine.
  std::size_t memory_limit = 0;

  // Called from the calling thread only, a few times a second at most. `stage` is a lower-case
  // noun ("delaunay"), `fraction` in [0, 1] is that of the whole job and never decreases.
  std::function<void(std::string_view stage, double fraction)> progress;

  // Set to true, from any thread or a signal handler, to make the call return ErrorCode::cancelled
  // soon. May be null.
  const std::atomic<bool>* cancel = nullptr;
};

}  // namespace arris
