// arris compare RESULT TRUTH
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "arris/arris.h"
#include "command.h"
#include "compare/compare.h"
#include "compare/error_map.h"
#include "comparison_text.h"
#include "exit_code.h"
#include "outputs.h"
#include "run_options.h"
#include "text.h"
#include "values.h"

#ifdef ARRIS_HAS_VIEWER
#include "error_picture.h"
#include "view_options.h"
#include "viewer/png.h"
#endif

namespace arris::cli {
namespace {

struct Arguments {
  std::string result, truth, map, picture;
  bool json = false;
  double full = compare::loose_tolerance;  // of the colours, in diagonals
  compare::CompareOptions options;
  RunOptions run;
#ifdef ARRIS_HAS_VIEWER
  viewer::View view;
#endif
};

// Shares of the parts in the whole, for the progress bar.
constexpr double read_end = 0.2, compare_end = 0.8, map_end = 0.9;

Result<void> check_arguments(const Arguments& arguments) {
#ifndef ARRIS_HAS_VIEWER
  if (!arguments.picture.empty())
    return Error{ErrorCode::unsupported, "arris was built without render",
                 "build it where libembree-dev 3 and libpng-dev are installed"};
#endif
  for (const std::string& input : {arguments.result, arguments.truth})
    if (auto ok = check_outputs(input, {{"the error map", arguments.map, {".ply"}},
                                        {"the picture", arguments.picture, {".png"}}});
        !ok)
      return ok;
  return {};
}

struct Meshes {
  Mesh result, truth;
};

Result<Meshes> read_both(const Arguments& arguments, Progress& progress) {
  const auto context = [&](double begin, double end) {
    return make_context(arguments.run, progress, begin, end);
  };
  auto result = read_mesh(arguments.result, context(0, read_end / 2));
  if (!result) return result.error();
  auto truth = read_mesh(arguments.truth, context(read_end / 2, read_end));
  if (!truth) return truth.error();
  return Meshes{std::move(*result), std::move(*truth)};
}

#ifdef ARRIS_HAS_VIEWER
Result<void> write_picture(const Arguments& arguments, const Meshes& meshes,
                           const compare::DistanceToMesh& to_truth, double full,
                           const Context& context) {
  const auto image =
      error_picture(meshes.result, meshes.truth, to_truth, full, arguments.view, context);
  if (!image) return image.error();
  return write_text(arguments.picture, viewer::encode_png(*image));
}
#endif

Result<void> write_maps(const Arguments& arguments, const Meshes& meshes, Progress& progress) {
  if (arguments.map.empty() && arguments.picture.empty()) return {};
  const Context context = make_context(arguments.run, progress, compare_end, map_end);
  const auto to_truth = compare::DistanceToMesh::make(meshes.truth, "truth", context);
  if (!to_truth) return to_truth.error();
  const double full = arguments.full * to_truth->diagonal();
  if (!arguments.map.empty()) {
    const auto map = compare::error_map(meshes.result, *to_truth, full, context);
    if (!map) return map.error();
    if (auto written = write_mesh(arguments.map, *map, context); !written) return written;
  }
#ifdef ARRIS_HAS_VIEWER
  if (!arguments.picture.empty())
    return write_picture(arguments, meshes, *to_truth, full,
                         make_context(arguments.run, progress, map_end, 1));
#endif
  return {};
}

void print(const Arguments& arguments, const compare::Comparison& comparison) {
  if (arguments.json)
    std::fputs(compare::to_json(comparison).c_str(), stdout);
  else if (!arguments.run.quiet)
    print_comparison(arguments.result, arguments.truth, comparison);
}

int run(const Arguments& arguments) {
  if (auto ok = check_arguments(arguments); !ok) return report_error(ok.error());
  Progress progress(progress_style(arguments.run));
  const auto fail = [&](const Error& error) {
    progress.clear();
    return report_error(error);
  };
  const auto meshes = read_both(arguments, progress);
  if (!meshes) return fail(meshes.error());
  const auto comparison =
      compare::compare_meshes(meshes->result, meshes->truth, arguments.options,
                              make_context(arguments.run, progress, read_end, compare_end));
  if (!comparison) return fail(comparison.error());
  const auto written = write_maps(arguments, *meshes, progress);
  if (!written) return fail(written.error());
  progress.clear();
  print(arguments, *comparison);
  return 0;
}

void add_compare_options(CLI::App& app, Arguments& arguments) {
  compare::CompareOptions& options = arguments.options;
  app.add_flag("--json", arguments.json, "Print all figures as JSON");
  app.add_option("--samples", options.samples,
                 "Samples on each surface, and lines through the volume (100000)")
      ->check(whole_number_in(1000, 100000000, "a whole number from 1000 to 100000000"));
  app.add_option("--seed", options.seed, "Another number draws other samples (1)")
      ->check(whole_number_in(0, 1000000000, "a whole number from 0 to 1000000000"));
  app.add_option("--dihedral", options.dihedral,
                 "An edge is sharp where the surface turns by so many degrees (30)")
      ->check(number_in(1, 180, "a number from 1 to 180"));
  app.add_option("--error-map", arguments.map,
                 "The result with the distance to the truth and a colour per vertex: .ply")
      ->check(not_empty())
      ->type_name("file");
  app.add_option("--picture", arguments.picture,
                 "Both meshes coloured by the distance to the other one: .png")
      ->check(not_empty())
      ->type_name("file");
  app.add_option("--error-full", arguments.full,
                 "Distance of the last colour, as a share of the truth's diagonal (0.005)")
      ->check(number_in(1e-9, 1, "a number from 1e-9 to 1"));
}

}  // namespace

std::function<int()> declare_compare(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("result", arguments->result, "Mesh to judge: .ply .obj .off .stl")
      ->required()
      ->check(not_empty())
      ->type_name("file");
  app.add_option("truth", arguments->truth, "Mesh that is right: .ply .obj .off .stl")
      ->required()
      ->check(not_empty())
      ->type_name("file");
  add_compare_options(app, *arguments);
#ifdef ARRIS_HAS_VIEWER
  add_camera_options(app, arguments->view);
#endif
  add_run_options(app, arguments->run);
  return [arguments] { return run(*arguments); };
}

}  // namespace arris::cli
