// arris model NAME -o MESH
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "arris/arris.h"
#include "command.h"
#include "exit_code.h"
#include "json_object.h"
#include "outputs.h"
#include "run_options.h"
#include "text.h"
#include "truth/csg.h"
#include "truth/models.h"
#include "truth/thickness.h"
#include "values.h"

namespace arris::cli {
namespace {

const char* const csg = "csg";  // the name of the random models

struct Arguments {
  std::string name, output;
  bool list = false, unit = false, json = false;
  std::optional<int> resolution;
  std::optional<std::uint64_t> seed;
  RunOptions run;
};

// A model and what is known of it.
struct Made {
  Mesh mesh;
  std::string recipe;  // of a random model
  truth::Thickness thickness;
  Certificate certificate;
};

int print_list() {
  for (const truth::ModelEntry& model : truth::models())
    std::printf("%-18s %s\n", model.name, model.summary);
  std::printf("%-18s %s\n", csg, "a random solid: boxes, prisms, cylinders, cones, balls, wedges");
  return 0;
}

bool is_known(const std::string& name) {
  for (const truth::ModelEntry& model : truth::models())
    if (name == model.name) return true;
  return name == csg;
}

Result<void> check_arguments(const Arguments& arguments) {
  const auto usage = [](const std::string& message, const std::string& remedy) {
    return Error{ErrorCode::usage, message, remedy};
  };
  if (arguments.name.empty()) return usage("name is required", "arris model --list names all");
  if (!is_known(arguments.name))
    return usage("there is no model " + quoted(arguments.name), "arris model --list names all");
  if (arguments.seed && arguments.name != csg)
    return usage("--seed is for the model csg only", "leave it out: this model is always the same");
  if (arguments.output.empty()) return usage("--output is required", "give it with -o FILE");
  return check_outputs("", {{"the mesh", arguments.output, {".ply", ".obj", ".off", ".stl"}}});
}

Result<Made> make(const Arguments& arguments) {
  Made made;
  if (arguments.name == csg) {
    const std::uint64_t seed = arguments.seed.value_or(1);
    truth::CsgModel model = arguments.resolution ? truth::random_csg(seed, *arguments.resolution)
                                                 : truth::random_csg(seed);
    made.mesh = std::move(model.mesh);
    made.recipe = std::move(model.recipe);
  } else {
    made.mesh =
        truth::make_model(arguments.name, arguments.resolution.value_or(truth::default_resolution));
  }
  if (arguments.unit) made.mesh = truth::to_unit_diagonal(std::move(made.mesh));
  made.thickness = truth::measure_thickness(made.mesh);
  const Result<Certificate> certificate = check(made.mesh);
  if (!certificate) return certificate.error();
  if (!certificate->ok())
    return Error{
        ErrorCode::certificate,
        "the model " + quoted(arguments.name) + " fails the check: " + certificate->first_defect,
        "try another resolution, and please report this one"};
  made.certificate = *certificate;
  return made;
}

std::string length_text(double length) {
  return std::isfinite(length) ? short_number(length) : "none";
}

void print_made(const Arguments& arguments, const Made& made) {
  const Certificate& c = made.certificate;
  std::printf("%s: %s, %s, %s, Euler %lld; certified\n", arguments.output.c_str(),
              counted(c.vertices, "vertex").c_str(), counted(c.triangles, "triangle").c_str(),
              counted(c.components, "component").c_str(), static_cast<long long>(c.euler));
  if (!made.recipe.empty()) std::printf("  recipe      %s\n", made.recipe.c_str());
  const truth::Thickness& t = made.thickness;
  std::printf("  volume      %s\n  area        %s\n", short_number(c.volume).c_str(),
              short_number(c.area).c_str());
  std::printf("  thinnest    wall %s, gap %s, detail %s, clearance %s, neck %s\n",
              length_text(t.wall).c_str(), length_text(t.gap).c_str(),
              length_text(t.detail).c_str(), length_text(t.clearance).c_str(),
              length_text(t.neck).c_str());
  std::printf("  samples     %s are dense enough\n",
              with_commas(truth::dense_samples(made.mesh, t)).c_str());
}

void print_json(const Arguments& arguments, const Made& made) {
  JsonObject json;
  json.add("name", arguments.name);
  if (arguments.name == csg) {
    json.add("seed", arguments.seed.value_or(1));
    json.add("recipe", made.recipe);
  }
  const Certificate& c = made.certificate;
  json.add("vertices", c.vertices);
  json.add("triangles", c.triangles);
  json.add("components", c.components);
  json.add("euler", c.euler);
  json.add("volume", c.volume);
  json.add("area", c.area);
  json.add("wall", made.thickness.wall);
  json.add("gap", made.thickness.gap);
  json.add("detail", made.thickness.detail);
  json.add("clearance", made.thickness.clearance);
  json.add("neck", made.thickness.neck);
  json.add("dense_samples", truth::dense_samples(made.mesh, made.thickness));
  json.print();
}

int run(const Arguments& arguments) {
  if (arguments.list) return print_list();
  if (auto ok = check_arguments(arguments); !ok) return report_error(ok.error());
  const Result<Made> made = make(arguments);
  if (!made) return report_error(made.error());
  Progress progress(Progress::Style::silent);
  const Context context = make_context(arguments.run, progress, 0, 1);
  if (auto ok = write_mesh(arguments.output, made->mesh, context); !ok)
    return report_error(ok.error());
  if (arguments.json)
    print_json(arguments, *made);
  else if (!arguments.run.quiet)
    print_made(arguments, *made);
  return 0;
}

}  // namespace

std::function<int()> declare_model(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("name", arguments->name, "One of those that --list names, or csg: a random solid")
      ->type_name("name");
  app.add_option("-o,--output", arguments->output, "Mesh to write: .ply .obj .off .stl")
      ->check(not_empty())
      ->type_name("file");
  app.add_flag("--list", arguments->list, "Name all models, and do nothing else");
  app.add_option("--seed", arguments->seed, "Which random solid, for csg (1)")
      ->check(whole_number_in(0, 1'000'000'000'000, "a whole number from 0 to 1000000000000"));
  app.add_option("--resolution", arguments->resolution, "Segments round a circle (192; for csg 96)")
      ->check(whole_number_in(truth::lowest_resolution, truth::highest_resolution,
                              "a whole number from 24 to 1024"));
  app.add_flag("--unit", arguments->unit,
               "Centre the model at 0 and scale the diagonal of its bounding box to 1");
  app.add_flag("--json", arguments->json, "Print what is known of the model as JSON");
  app.add_flag("--quiet,-q", arguments->run.quiet, "Print nothing unless something fails");
  return [arguments] { return run(*arguments); };
}

}  // namespace arris::cli
