// arris check MESH
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "arris/arris.h"
#include "command.h"
#include "exit_code.h"
#include "run_options.h"
#include "summary.h"
#include "text.h"

namespace arris::cli {
namespace {

struct Arguments {
  std::string input;
  bool json = false;
  bool open = false;
  RunOptions run;
};

constexpr double read_end = 0.2;  // share of reading in the whole, for the progress bar

Error defect(const std::string& path, const Certificate& certificate) {
  const std::string what =
      certificate.first_defect.empty() ? "it has no triangles" : certificate.first_defect;
  return {ErrorCode::certificate, quoted(path) + " fails the check: " + what,
          "reconstruct it from its points with arris reconstruct, or repair it"};
}

int run(const Arguments& arguments) {
  Progress progress(progress_style(arguments.run));
  const auto fail = [&](const Error& error) {
    progress.clear();
    return report_error(error);
  };
  const auto mesh = read_mesh(arguments.input, make_context(arguments.run, progress, 0, read_end));
  if (!mesh) return fail(mesh.error());
  const auto certificate = check(*mesh, make_context(arguments.run, progress, read_end, 1));
  if (!certificate) return fail(certificate.error());

  progress.clear();
  if (arguments.json)
    print_certificate_json(*certificate);
  else if (!arguments.run.quiet)
    print_certificate(arguments.input, *certificate);
  const bool passed = certificate->ok() || (arguments.open && certificate->sound());
  return passed ? 0 : report_error(defect(arguments.input, *certificate));
}

}  // namespace

std::function<int()> declare_check(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("mesh", arguments->input, "Mesh: .ply .obj .off .stl")
      ->required()
      ->type_name("file");
  app.add_flag("--json", arguments->json, "Print the certificate as JSON");
  app.add_flag("--open", arguments->open,
               "Pass a mesh with a boundary, such as a trimmed one, if all else is well");
  add_run_options(app, arguments->run);
  return [arguments] { return run(*arguments); };
}

}  // namespace arris::cli
