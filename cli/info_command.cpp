// arris info FILE
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

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
  RunOptions run;
};

bool finite(const Vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::string text_of(const Vec3& p) {
  return exact_number(p.x) + " " + exact_number(p.y) + " " + exact_number(p.z);
}

const char* name_of(ScalarType type) {
  static constexpr std::array<const char*, 8> names = {"int8",  "uint8",  "int16",   "uint16",
                                                       "int32", "uint32", "float32", "float64"};
  return names.at(static_cast<std::size_t>(type));
}

// Points that equal an earlier one.
std::size_t count_duplicates(std::vector<Vec3> points) {
  const auto key = [](const Vec3& p) { return std::tie(p.x, p.y, p.z); };
  std::sort(points.begin(), points.end(),
            [&](const Vec3& a, const Vec3& b) { return key(a) < key(b); });
  const auto distinct = std::unique(points.begin(), points.end());
  return static_cast<std::size_t>(points.end() - distinct);
}

void print_positions(const std::vector<Vec3>& positions) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Vec3 low{inf, inf, inf}, high{-inf, -inf, -inf};
  std::vector<Vec3> good;
  std::copy_if(positions.begin(), positions.end(), std::back_inserter(good), finite);
  for (const Vec3& p : good) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const std::size_t bad = positions.size() - good.size();
  if (bad > 0) std::printf("  non-finite  %s\n", with_commas(bad).c_str());
  if (good.empty()) return;
  std::printf("  box         %s .. %s\n", text_of(low).c_str(), text_of(high).c_str());
  std::printf("  size        %s %s %s\n", short_number(high.x - low.x).c_str(),
              short_number(high.y - low.y).c_str(), short_number(high.z - low.z).c_str());
  std::printf("  duplicates  %s\n", with_commas(count_duplicates(std::move(good))).c_str());
}

void print_attributes(const char* label, const std::vector<Attribute>& attributes) {
  for (const Attribute& attribute : attributes) {
    const auto [low, high] = std::minmax_element(attribute.values.begin(), attribute.values.end());
    std::printf("  %s%s, %s", label, attribute.name.c_str(), name_of(attribute.type));
    if (low != attribute.values.end())
      std::printf(", %s .. %s", short_number(*low).c_str(), short_number(*high).c_str());
    std::printf("\n");
  }
}

// The sharp edges, if the mesh is sound enough to have any.
void print_features(const Mesh& mesh, const Context& context) {
  const auto network = find_features(mesh, context);
  if (!network) return;
  const FeatureCounts counts = count_features(*network);
  std::printf("  features    %s, %s, %s\n", counted(counts.curves, "curve").c_str(),
              counted(counts.corners, "corner").c_str(), counted(counts.patches, "patch").c_str());
}

bool has_extension(const std::string& path, const char* extension) {
  std::string own = std::filesystem::path(path).extension().string();
  std::transform(own.begin(), own.end(), own.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return own == extension;
}

int describe_mesh_only(const Arguments& arguments, const Context& context) {
  const auto mesh = read_mesh(arguments.input, context);
  if (!mesh) return report_error(mesh.error());
  std::printf("%s: %s, %s\n", arguments.input.c_str(),
              counted(mesh->vertices.size(), "vertex").c_str(),
              counted(mesh->triangles.size(), "triangle").c_str());
  print_features(*mesh, context);
  print_positions(mesh->vertices);
  return 0;
}

// Files that can hold faces are read a second time as a mesh.
void print_faces(const Arguments& arguments, const Context& context) {
  if (!has_extension(arguments.input, ".ply") && !has_extension(arguments.input, ".off") &&
      !has_extension(arguments.input, ".obj"))
    return;
  const auto mesh = read_mesh(arguments.input, context);
  if (!mesh || mesh->triangles.empty()) return;
  std::printf("  triangles   %s\n", with_commas(mesh->triangles.size()).c_str());
  print_features(*mesh, context);
  print_attributes("of faces    ", mesh->face_attributes);
}

int run(const Arguments& arguments) {
  Progress progress(Progress::Style::silent);
  const Context context = make_context(arguments.run, progress, 0, 1);
  if (has_extension(arguments.input, ".stl")) return describe_mesh_only(arguments, context);
  const auto cloud = read_points(arguments.input, context);
  if (!cloud) return report_error(cloud.error());
  const std::size_t points = cloud->positions.size();
  std::printf("%s: %s, %s positions\n", arguments.input.c_str(), counted(points, "point").c_str(),
              name_of(cloud->position_type));
  print_faces(arguments, context);
  print_positions(cloud->positions);
  print_attributes("attribute   ", cloud->attributes);
  std::printf("  memory      %s to reconstruct, at most\n",
              human_bytes(forecast_memory(points)).c_str());
  print_warnings(cloud->warnings);
  return 0;
}

}  // namespace

std::function<int()> declare_info(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("file", arguments->input, "Points or a mesh, of any type that arris reads")
      ->required()
      ->type_name("file");
  return [arguments] { return run(*arguments); };
}

}  // namespace arris::cli
