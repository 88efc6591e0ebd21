// The options that every long command has: threads, memory, how much it says.
#pragma once

#include <cstddef>

#include "arris/context.h"
#include "terminal.h"

namespace CLI {
class App;
}

namespace arris::cli {

struct RunOptions {
  unsigned threads = 0;
  std::size_t memory_limit = 0;
  bool quiet = false;
  bool verbose = false;
};

// Declares --threads, --memory-limit and --quiet; the verbose flag is left to the command.
void add_run_options(CLI::App& app, RunOptions& options);

Progress::Style progress_style(const RunOptions& options);

// A context for the part [begin, end] of the command's work, stopped by signals. `progress` must
// outlive it.
Context make_context(const RunOptions& options, Progress& progress, double begin, double end);

}  // namespace arris::cli
