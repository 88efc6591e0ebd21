// arris sample MESH -n N -o CLOUD
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "arris/arris.h"
#include "command.h"
#include "exit_code.h"
#include "outputs.h"
#include "run_options.h"
#include "text.h"
#include "truth/cloud.h"
#include "values.h"

namespace arris::cli {
namespace {

struct Arguments {
  std::string input, output;
  std::string noise_direction;  // empty: that of the mode
  truth::CloudOptions cloud;
  bool quiet = false;
};

// A number from 0 to `most` with a unit of one character behind it, or none.
std::optional<double> parse_up_to(double most, std::string_view text, bool unit) {
  const auto value = parse_number(text.substr(0, text.size() - unit));
  return value && *value >= 0 && *value <= most ? value : std::nullopt;  // not NaN
}

// "5%" or "0.05".
double parse_share(const char* option, const std::string& text, double most, const char* range) {
  const bool percent = text.ends_with('%');
  const auto value = parse_up_to(percent ? 100 * most : most, text, percent);
  if (!value)
    throw CLI::ValidationError(option, "must be a share from 0 to " + std::string(range) +
                                           ", such as 5% or 0.05, not " + quoted(text));
  return percent ? *value / 100 : *value;
}

// "0.25%" or "0.0025" of the diagonal, "0.2h" of the spacing.
void parse_noise(const std::string& text, truth::CloudOptions& cloud) {
  constexpr double most_spacings = 100;
  cloud.noise_in_spacings = text.ends_with('h');
  if (!cloud.noise_in_spacings) {
    cloud.noise = parse_share("--noise", text, 1, "1 of the diagonal (or spacings, such as 0.2h)");
    return;
  }
  const auto value = parse_up_to(most_spacings, text, true);
  if (!value)
    throw CLI::ValidationError("--noise",
                               "must be from 0h to 100h, such as 0.2h, not " + quoted(text));
  cloud.noise = *value;
}

Result<void> check_arguments(const Arguments& arguments) {
  const bool scan = arguments.cloud.sampling.mode == truth::Mode::scan;
  const std::string& direction = arguments.noise_direction;
  if ((direction == "ray" && !scan) || (direction == "normal" && scan))
    return Error{ErrorCode::usage,
                 scan ? "a scan has noise along its rays, not along normals"
                      : "only a scan has rays along which noise can act",
                 scan ? "use --noise-direction ray or isotropic"
                      : "use --noise-direction normal or isotropic, or --mode scan"};
  return check_outputs(arguments.input,
                       {{"the cloud", arguments.output, {".ply", ".obj", ".off"}}});
}

Result<truth::Cloud> draw(const Mesh& mesh, const truth::CloudOptions& options) {
  try {
    return truth::make_cloud(mesh, options);
  } catch (const std::invalid_argument& e) {
    return Error{ErrorCode::degenerate, std::string("there is nothing to sample: ") + e.what(),
                 "give a mesh with faces that have an area, and smaller patches if any"};
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::out_of_memory, "the machine has no memory left for so many samples",
                 "ask for fewer"};
  }
}

void print_cloud(const Arguments& arguments, const truth::Cloud& cloud) {
  std::printf("%s: %s, spacing %s", arguments.output.c_str(),
              counted(cloud.points.positions.size(), "point").c_str(),
              short_number(cloud.spacing).c_str());
  if (cloud.outliers > 0) std::printf(", %s", counted(cloud.outliers, "outlier").c_str());
  if (cloud.missing > 0) std::printf(", %s missing", with_commas(cloud.missing).c_str());
  std::printf("\n");
}

// Nothing catches signals before the cloud is written: until then the process may just end.
int run(Arguments& arguments) {
  if (auto ok = check_arguments(arguments); !ok) return report_error(ok.error());
  if (arguments.noise_direction == "isotropic")
    arguments.cloud.noise_direction = truth::NoiseDirection::isotropic;
  const Result<Mesh> mesh = read_mesh(arguments.input);
  if (!mesh) return report_error(mesh.error());
  Result<truth::Cloud> cloud = draw(*mesh, arguments.cloud);
  if (!cloud) return report_error(cloud.error());

  Mesh points;  // one without faces is written as its points
  points.vertices = cloud->points.positions;
  points.position_type = cloud->points.position_type;
  Progress progress(Progress::Style::silent);
  const Context context = make_context({}, progress, 0, 1);
  if (auto ok = write_mesh(arguments.output, points, context); !ok) return report_error(ok.error());
  if (!arguments.quiet) print_cloud(arguments, *cloud);
  return 0;
}

void add_sampling_options(CLI::App& app, truth::Sampling& sampling) {
  app.add_option("-n,--samples", sampling.samples,
                 "Samples on the surface, before patches are taken out and outliers are added")
      ->required()
      ->check(whole_number_in(1, 20'000'000, "a whole number from 1 to 20000000"));
  const Choices<truth::Mode> modes = {{"uniform", truth::Mode::uniform},
                                      {"blue", truth::Mode::blue},
                                      {"feature", truth::Mode::feature},
                                      {"graded", truth::Mode::graded},
                                      {"scan", truth::Mode::scan}};
  add_choice(app, "--mode", modes, sampling.mode,
             "uniform: independent by area; blue: evenly spread (the default); feature: corners, "
             "sharp edges, then evenly spread; graded: ten times denser at one end; scan: range "
             "images from all sides, with occlusion");
  app.add_option("--seed", sampling.seed, "Another cloud of the same kind (1)")
      ->check(whole_number_in(0, 1'000'000'000'000, "a whole number from 0 to 1000000000000"));
  app.add_option("--edge-angle", sampling.edge_angle,
                 "Degrees by which the surface turns at a sharp edge, for feature (30)")
      ->check(number_in(0, 180, "a number from 0 to 180"));
  app.add_option("--views", sampling.views, "Places to scan from (12)")
      ->check(whole_number_in(1, 1000, "a whole number from 1 to 1000"));
}

void add_spoiling_options(CLI::App& app, Arguments& arguments) {
  truth::CloudOptions& cloud = arguments.cloud;
  app.add_option_function<std::string>(
         "--noise", [&cloud](const std::string& text) { parse_noise(text, cloud); },
         "Standard deviation: a share of the diagonal, such as 0.25%, or of the spacing: 0.2h")
      ->type_name("share");
  const Choices<std::string> directions = {
      {"normal", "normal"}, {"ray", "ray"}, {"isotropic", "isotropic"}};
  add_choice(app, "--noise-direction", directions, arguments.noise_direction,
             "Along the normal (the default), along the ray (the default of a scan), or the same "
             "in every coordinate");
  app.add_option_function<std::string>(
         "--outliers",
         [&cloud](const std::string& text) {
           cloud.outliers = parse_share("--outliers", text, 10, "10");
         },
         "So many more points anywhere in the padded bounding box, as a share: 5%")
      ->type_name("share");
  app.add_option("--missing", cloud.missing, "Round patches without samples (0)")
      ->check(whole_number_in(0, 1000, "a whole number from 0 to 1000"));
  app.add_option_function<std::string>(
         "--missing-radius",
         [&cloud](const std::string& text) {
           cloud.missing_radius = parse_share("--missing-radius", text, 1, "1 of the diagonal");
         },
         "Their radius, as a share of the diagonal (8%)")
      ->type_name("share");
}

}  // namespace

std::function<int()> declare_sample(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("mesh", arguments->input, "Mesh: .ply .obj .off .stl")
      ->required()
      ->check(not_empty())
      ->type_name("file");
  app.add_option("-o,--output", arguments->output, "Points to write: .ply .obj .off")
      ->required()
      ->check(not_empty())
      ->type_name("file");
  add_sampling_options(app, arguments->cloud.sampling);
  add_spoiling_options(app, *arguments);
  app.add_flag("--quiet,-q", arguments->quiet, "Print nothing unless something fails");
  return [arguments] { return run(*arguments); };
}

}  // namespace arris::cli
