#include "run_options.h"

#include <CLI/CLI.hpp>

#include "signals.h"
#include "values.h"

namespace arris::cli {

void add_run_options(CLI::App& app, RunOptions& options) {
  app.add_option("--threads", options.threads,
                 "Worker threads; 0: one per processor. The result is the same for any number")
      ->check(whole_number_in(0, 256, "a whole number from 0 to 256"));
  app.add_option_function<std::string>(
         "--memory-limit",
         [&options](const std::string& text) { options.memory_limit = parse_bytes(text); },
         "Refuse work that needs more, e.g. 4G or 512M; default: the memory of the machine")
      ->type_name("size");
  app.add_flag("--quiet,-q", options.quiet, "Print nothing unless something fails");
}

Progress::Style progress_style(const RunOptions& options) {
  return options.quiet ? Progress::Style::silent : Progress::style_of_stderr();
}

Context make_context(const RunOptions& options, Progress& progress, double begin, double end) {
  Context context;
  context.threads = options.threads;
  context.memory_limit = options.memory_limit;
  context.progress = progress.part(begin, end);
  context.cancel = cancel_on_signals();
  return context;
}

}  // namespace arris::cli
