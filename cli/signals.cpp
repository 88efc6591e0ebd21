#include "signals.h"

#include <signal.h>

namespace arris::cli {
namespace {

// A signal handler takes no argument, so the flag must be global. A lock-free atomic store is
// async-signal-safe.
std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void on_signal(int) {
  stop.store(true, std::memory_order_relaxed);
}

}  // namespace

const std::atomic<bool>* cancel_on_signals() {
  struct sigaction action {};
  sigemptyset(&action.sa_mask);
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;  // a read in progress goes on; the flag is seen after it
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    // Under nohup or in the background of a shell script a signal is ignored on purpose.
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
  action.sa_handler = SIG_IGN;
  for (const int signal : {SIGPIPE, SIGXFSZ}) sigaction(signal, &action, nullptr);
  return &stop;
}

bool interrupted() noexcept {
  return stop.load(std::memory_order_relaxed);
}

}  // namespace arris::cli
