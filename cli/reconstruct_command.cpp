// arris reconstruct IN -o OUT
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "arris/arris.h"
#include "command.h"
#include "exit_code.h"
#include "outputs.h"
#include "run_options.h"
#include "summary.h"
#include "values.h"

namespace arris::cli {
namespace {

struct Arguments {
  std::string input, mesh, tetrahedra, features, report;
  Options options;
  RunOptions run;
  bool confidence = false;
};

// Shares of the whole command, for the progress bar.
constexpr double read_end = 0.05, reconstruct_end = 0.95, mesh_end = 0.98;

Result<void> write_outputs(const Arguments& arguments, const Reconstruction& result,
                           Progress& progress) {
  const Context mesh_context = make_context(arguments.run, progress, reconstruct_end, mesh_end);
  if (auto done = write_mesh(arguments.mesh, result.mesh, mesh_context); !done) return done;
  if (!arguments.tetrahedra.empty()) {
    const Context context = make_context(arguments.run, progress, mesh_end, 1);
    if (auto done = write_tetrahedra(arguments.tetrahedra, result.volume, context); !done)
      return done;
  }
  if (!arguments.features.empty())
    if (auto done = write_features(arguments.features, result.mesh, result.features); !done)
      return done;
  if (!arguments.report.empty()) return write_text(arguments.report, to_json(result.report) + "\n");
  return {};
}

// What is known of each face, as attributes.
void add_face_attributes(Reconstruction& result) {
  auto& attributes = result.mesh.face_attributes;
  attributes.push_back(
      {"support", ScalarType::f32, {result.support.begin(), result.support.end()}});
  attributes.push_back({"filled", ScalarType::u8, {result.filled.begin(), result.filled.end()}});
  const auto& patch = result.features.patch;
  attributes.push_back({"patch", ScalarType::i32, {patch.begin(), patch.end()}});
}

// The seed confidence as one more attribute of the vertices, unless the input has one of that name.
void add_confidence(Reconstruction& result) {
  const char* const name = "confidence";
  for (const Attribute& a : result.mesh.attributes)
    if (a.name == name) return;
  result.mesh.attributes.push_back(
      {name, ScalarType::f32, {result.confidence.begin(), result.confidence.end()}});
}

int run(const Arguments& arguments) {
  const Result<void> outputs = check_outputs(
      arguments.input, {{"the mesh", arguments.mesh, {".ply", ".obj", ".off", ".stl"}},
                        {"the volume", arguments.tetrahedra, {".msh", ".vtk"}},
                        {"the network of curves", arguments.features, {".ply", ".obj", ".json"}},
                        {"the report", arguments.report, {}}});
  if (!outputs) return report_error(outputs.error());

  Progress progress(progress_style(arguments.run));
  const auto fail = [&](const Error& error) {
    progress.clear();
    return report_error(error);
  };
  const auto cloud =
      read_points(arguments.input, make_context(arguments.run, progress, 0, read_end));
  if (!cloud) return fail(cloud.error());
  auto result = reconstruct(*cloud, arguments.options,
                            make_context(arguments.run, progress, read_end, reconstruct_end));
  if (!result) return fail(result.error());
  add_face_attributes(*result);
  if (arguments.confidence) add_confidence(*result);
  const auto written = write_outputs(arguments, *result, progress);
  if (!written) return fail(written.error());

  progress.clear();
  if (!arguments.run.quiet) {
    print_warnings(result->report.warnings);
    print_summary(arguments.mesh, result->report, progress.seconds());
    if (arguments.run.verbose) print_details(result->report);
  }
  return 0;
}

void add_method_options(CLI::App& app, Options& options) {
  const Choices<Method> methods = {{"default", Method::automatic}, {"paper", Method::paper}};
  const Choices<Curvature> curvatures = {{"area", Curvature::area},
                                         {"cotangent", Curvature::cotangent},
                                         {"polyhedral", Curvature::polyhedral}};
  add_choice(app, "--method", methods, options.method,
             "How: the default, or the setting of the paper by Shi, Wan, Tai and Wang (2011)");
  app.add_option("--lambda", options.lambda,
                 "Weight of curvature against distance, in squares of the sample spacing (0.1)")
      ->check(number_in(0, 1e6, "a number from 0 to 1000000"));
  app.add_option("--cycles", options.cycles, "Cuts, each with the curvature of the last surface")
      ->check(whole_number_in(1, 100, "a whole number from 1 to 100"));
  app.add_option("--background", options.background,
                 "Background points per sample (0 by default, 10 with --method paper)")
      ->check(number_in(0, 1000, "a number from 0 to 1000"));
  add_choice(app, "--curvature", curvatures, options.curvature,
             "How the swaps measure curvature; area: minimal area instead, to compare with");
  const Choices<Outliers> outliers = {
      {"auto", Outliers::by_method}, {"drop", Outliers::drop}, {"keep", Outliers::keep}};
  add_choice(app, "--outliers", outliers, options.outliers,
             "Points that belong to no surface: dropped, but for --method paper");
  app.add_option("--noise", options.noise,
                 "Standard deviation of the noise, in the unit of the points; 0 leaves the points "
                 "where they are (estimated by default, 0 with --method paper)")
      ->check(number_in(0, 1e300, "a number from 0"));
  app.add_flag_callback(
      "--no-swap", [&options] { options.swap = false; }, "Leave the swaps out");
  app.add_flag_callback(
      "--free-samples", [&options] { options.keep_samples = false; },
      "Let swaps take samples off the surface, to compare with: edges are lost");
  app.add_flag_callback(
      "--no-sharpen", [&options] { options.sharpen = false; },
      "Add no points: on edges and corners that no sample lies on, and in gaps on curved surface");
  app.add_flag(
      "--refine", options.refine,
      "Add points on the smooth surface between all samples where it is curved, not only in gaps");
  app.add_flag_callback(
      "--drop-non-finite", [&options] { options.non_finite = NonFinite::drop; },
      "Leave out points with NaN or infinite coordinates instead of refusing them");
}

}  // namespace

std::function<int()> declare_reconstruct(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("input", arguments->input,
                 "Points: .ply .xyz .txt .csv .pts .asc .off .obj; only positions are needed")
      ->required()
      ->check(not_empty())
      ->type_name("file");
  app.add_option("-o,--output", arguments->mesh, "Mesh to write: .ply .obj .off .stl")
      ->required()
      ->check(not_empty())
      ->type_name("file");
  app.add_option("--tets", arguments->tetrahedra,
                 "Also write the interior tetrahedra: .msh (Gmsh) .vtk (ParaView)")
      ->check(not_empty())
      ->type_name("file");
  app.add_option("--features", arguments->features,
                 "Also write the sharp edges as curves, with corners: .ply .obj .json")
      ->check(not_empty())
      ->type_name("file");
  app.add_option("--report", arguments->report, "Also write a report, as JSON")
      ->check(not_empty())
      ->type_name("file");
  app.add_flag("--trim", arguments->options.trim,
               "Leave out the faces that no sample supports: the mesh is then open");
  app.add_flag("--confidence", arguments->confidence,
               "Write, per vertex of a .ply, what share of the evidence there agrees");
  add_method_options(app, arguments->options);
  add_run_options(app, arguments->run);
  app.add_flag("--verbose,-v", arguments->run.verbose, "Also print counts and times per stage")
      ->excludes("--quiet");
  return [arguments] {
    arguments->options.tetrahedra = !arguments->tetrahedra.empty();
    return run(*arguments);
  };
}

}  // namespace arris::cli
