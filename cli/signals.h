// Ctrl-C: signals become the cancel flag of the library, so that files are left whole.
#pragma once

#include <atomic>

namespace arris::cli {

// From now on SIGINT, SIGTERM and SIGHUP set the flag that is returned instead of ending the
// process; writing past a file size limit or to a closed pipe becomes an ordinary write error.
const std::atomic<bool>* cancel_on_signals();

// A signal has arrived.
bool interrupted() noexcept;

}  // namespace arris::cli
