// What a subcommand is. The table of all of them is in main.cpp.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace arris::cli {

// One subcommand. `declare` adds its options to `app` and returns the work to do once the command
// line has been parsed; the work returns the exit code of the process.
struct Command {
  const char* name;
  const char* summary;
  std::function<int()> (*declare)(CLI::App& app);
};

std::function<int()> declare_reconstruct(CLI::App& app);
std::function<int()> declare_check(CLI::App& app);
std::function<int()> declare_info(CLI::App& app);
std::function<int()> declare_compare(CLI::App& app);
std::function<int()> declare_render(CLI::App& app);
std::function<int()> declare_model(CLI::App& app);
std::function<int()> declare_sample(CLI::App& app);

}  // namespace arris::cli
