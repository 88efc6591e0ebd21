// The command `arris`: a table of subcommands, help, and the mapping of parse errors to exit codes.
#include <CLI/CLI.hpp>
#include <array>
#include <cctype>
#include <cstdio>
#include <exception>
#include <map>
#include <string>

#include "arris/error.h"
#include "arris/version.h"
#include "command.h"
#include "exit_code.h"
#include "text.h"

namespace arris::cli {
namespace {

constexpr std::array commands = {
    Command{"reconstruct", "Points in, certified mesh out", declare_reconstruct},
    Command{"check", "Examine any mesh: closed, manifold, no self-intersection", declare_check},
    Command{"info", "Say what is in a file", declare_info},
    Command{"compare", "Hold a mesh against the truth", declare_compare},
    Command{"render", "Draw meshes or points as a picture", declare_render},
    Command{"model", "Make a solid with known truth", declare_model},
    Command{"sample", "Draw a point cloud from a mesh, clean or spoiled", declare_sample},
};

const char* const examples =
    "arris turns a raw point cloud into a closed, manifold, intersection-free triangle mesh.\n"
    "\n"
    "  arris reconstruct scan.ply -o mesh.ply                        points to mesh\n"
    "  arris reconstruct scan.xyz -o mesh.obj --report report.json   with a report\n"
    "  arris check mesh.ply                                          examine any mesh\n"
    "\n"
    "arris help lists the commands, arris help COMMAND their options.\n";

int usage_error(const std::string& message, const std::string& remedy) {
  return report_error({ErrorCode::usage, message, remedy});
}

// "arris help [COMMAND]"
int print_help(const CLI::App& app, const std::string& about) {
  if (about.empty()) {
    // Not app.help(): that explains the subcommand that was parsed, if any.
    const std::string text =
        app.get_formatter()->make_help(&app, "arris", CLI::AppFormatMode::Normal);
    std::fputs(text.c_str(), stdout);
    return 0;
  }
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    if (command->get_name() != about) continue;
    std::fputs(command->help("arris").c_str(), stdout);
    return 0;
  }
  return usage_error("there is no command " + quoted(about), "arris help lists the commands");
}

// The command line that was asked about, for the remedy: "arris help reconstruct".
std::string help_for(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  if (parsed.empty() || parsed.front()->get_name() == "help") return "arris help";
  return "arris help " + parsed.front()->get_name();
}

int parse_failure(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    // --help and --version arrive as errors that are none.
    if (error.get_name() == "CallForVersion") {
      std::printf("%s\n", error.what());
      return 0;
    }
    const auto parsed = app.get_subcommands();
    return print_help(app, parsed.empty() ? "" : parsed.front()->get_name());
  }
  std::string message = error.what();
  if (!message.empty())
    message[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(message[0])));
  return usage_error(message, "see " + help_for(app));
}

int run(int argc, char** argv) {
  CLI::App app("A raw point cloud in, a closed, manifold, intersection-free mesh out.", "arris");
  app.set_version_flag("--version", std::string("arris ") + version());
  app.footer(exit_codes_help);
  app.require_subcommand(0, 1);
  std::map<const CLI::App*, std::function<int()>> work;
  for (const Command& command : commands) {
    CLI::App* sub = app.add_subcommand(command.name, command.summary);
    sub->footer(exit_codes_help);
    work[sub] = command.declare(*sub);
  }
  std::string about;
  CLI::App* help = app.add_subcommand("help", "Explain arris, or one of its commands");
  help->add_option("command", about, "The command to explain")->type_name("name");
  work[help] = [&] { return print_help(app, about); };

  if (argc < 2) {
    std::fputs(examples, stdout);
    return 0;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return parse_failure(app, error);
  }
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? usage_error("no command given", "see arris help")
                        : work.at(chosen.front())();
}

}  // namespace
}  // namespace arris::cli

int main(int argc, char** argv) {
  try {
    return arris::cli::run(argc, argv);
  } catch (const std::exception& error) {
    return arris::cli::report_error({arris::ErrorCode::internal,
                                     std::string("unexpected failure: ") + error.what(),
                                     "please report it with the command line"});
  }
}
