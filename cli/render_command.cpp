// arris render FILE... -o PICTURE
#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "arris/arris.h"
#include "command.h"
#include "exit_code.h"
#include "outputs.h"
#include "run_options.h"
#include "summary.h"
#include "text.h"
#include "values.h"

#ifdef ARRIS_HAS_VIEWER
#include "view_options.h"
#include "viewer/png.h"
#include "viewer/render.h"
#endif

namespace arris::cli {

#ifdef ARRIS_HAS_VIEWER
namespace {

struct Arguments {
  std::vector<std::string> inputs, captions;
  std::string picture;
  bool points = false;
  viewer::View view;
  RunOptions run;
};

constexpr double read_end = 0.5;  // share of reading in the whole, for the progress bar

bool is_cancelled(const Error& error) {
  return error.code == ErrorCode::cancelled;
}

// A file without faces is drawn as points, with a warning that says why.
Result<viewer::Panel> read_panel(const std::string& path, bool points_only, const Context& context,
                                 std::vector<std::string>& warnings) {
  viewer::Panel panel;
  if (!points_only) {
    Result<Mesh> mesh = read_mesh(path, context);
    if (mesh) {
      panel.mesh = std::move(*mesh);
      return panel;
    }
    const ErrorCode code = mesh.error().code;
    if (code != ErrorCode::unsupported && code != ErrorCode::unreadable) return mesh.error();
    Result<PointCloud> cloud = read_points(path, context);
    if (!cloud) return is_cancelled(cloud.error()) ? cloud.error() : mesh.error();
    if (code == ErrorCode::unreadable)
      warnings.push_back(mesh.error().message + "; drawn as points");
    panel.points = std::move(cloud->positions);
    return panel;
  }
  Result<PointCloud> cloud = read_points(path, context);
  if (!cloud) return cloud.error();
  panel.points = std::move(cloud->positions);
  return panel;
}

Result<void> check_arguments(const Arguments& arguments) {
  for (const std::string& input : arguments.inputs)
    if (auto ok = check_outputs(input, {{"the picture", arguments.picture, {".png"}}}); !ok)
      return ok;
  if (arguments.captions.size() > arguments.inputs.size())
    return Error{ErrorCode::usage, "there are more captions than files",
                 "give one --caption per file, in the same order"};
  return {};
}

Result<void> draw(const Arguments& arguments, Progress& progress,
                  std::vector<std::string>& warnings) {
  const auto& inputs = arguments.inputs;
  const double share = read_end / static_cast<double>(inputs.size());
  std::vector<viewer::Panel> panels;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double begin = share * static_cast<double>(i);
    const Context context = make_context(arguments.run, progress, begin, begin + share);
    Result<viewer::Panel> panel = read_panel(inputs[i], arguments.points, context, warnings);
    if (!panel) return panel.error();
    if (i < arguments.captions.size()) panel->caption = arguments.captions[i];
    panels.push_back(std::move(*panel));
  }
  const Context context = make_context(arguments.run, progress, read_end, 1);
  const Result<viewer::Image> image = viewer::render(panels, arguments.view, context);
  if (!image) return image.error();
  return write_text(arguments.picture, viewer::encode_png(*image));
}

int run(const Arguments& arguments) {
  if (auto ok = check_arguments(arguments); !ok) return report_error(ok.error());
  Progress progress(progress_style(arguments.run));
  std::vector<std::string> warnings;
  const Result<void> done = draw(arguments, progress, warnings);
  progress.clear();
  if (!arguments.run.quiet) print_warnings(warnings);
  return done ? 0 : report_error(done.error());
}

void add_view_options(CLI::App& app, viewer::View& view) {
  add_camera_options(app, view);
  app.add_option("--edge-angle", view.edge_angle,
                 "Draw edges at which the surface turns by more than so many degrees (30)")
      ->check(number_in(0, 180, "a number from 0 to 180"));
  app.add_flag("--wireframe", view.wireframe, "Draw all edges");
  app.add_option("--point-size", view.point_size, "Pixels across a point (4)")
      ->check(number_in(0.1, 1000, "a number from 0.1 to 1000"));
  app.add_option("--columns", view.columns, "Pictures a row (all in one row)")
      ->check(whole_number_in(1, 1000, "a whole number from 1 to 1000"));
  app.add_flag("--common-frame", view.common_frame,
               "Show all files at one scale and position, instead of each at its own");
  app.add_option("--samples", view.quality.supersampling, "Rays per pixel and axis (3)")
      ->check(whole_number_in(1, 16, "a whole number from 1 to 16"));
  app.add_option("--occlusion", view.quality.occlusion,
                 "Rays per pixel for the shade in hollows (64); 0 leaves it out")
      ->check(whole_number_in(0, 4096, "a whole number from 0 to 4096"));
}

}  // namespace

std::function<int()> declare_render(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  app.add_option(
         "files", arguments->inputs,
         "Meshes or points, drawn side by side: .ply .obj .off .stl .xyz .txt .csv .pts .asc")
      ->required()
      ->check(not_empty())
      ->type_name("file");
  app.add_option("-o,--output", arguments->picture, "Picture to write: .png")
      ->required()
      ->check(not_empty())
      ->type_name("file");
  app.add_option("--caption", arguments->captions, "Text below each file, once per file, in order")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false)  // what follows one caption is a file
      ->type_name("text");
  app.add_flag("--points", arguments->points, "Draw points even where files have faces");
  add_view_options(app, arguments->view);
  add_run_options(app, arguments->run);
  return [arguments] { return run(*arguments); };
}

#else

// Built without the libraries of the renderer.
std::function<int()> declare_render(CLI::App& app) {
  app.allow_extras();
  return [] {
    return report_error({ErrorCode::unsupported, "arris was built without render",
                         "build it where libembree-dev 3 and libpng-dev are installed"});
  };
}

#endif

}  // namespace arris::cli
