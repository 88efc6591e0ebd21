#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "arris/report.h"
#include "arris/version.h"

namespace arris::test {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> out;
  for (const auto& [key, value] : object.items()) out.push_back(key);
  return out;
}

Report full_report() {
  Report r;
  r.options.method = Method::paper;
  r.options.curvature = Curvature::cotangent;
  r.options.non_finite = NonFinite::drop;
  r.options.lambda = 0.1;
  r.options.outliers = Outliers::keep;
  r.stray_outliers = 7;
  r.surface_outliers = 2;
  r.threads = 3;
  r.input_points = 18446744073709551615u;
  r.shift = {1.5, -2.5, 1e300};
  r.cut_energy = {3.25, 0.1};
  r.filled_area = 0.25;
  r.trimmed = true;
  r.features.curves = 12;
  r.features.length = 1.5;
  r.stages = {{"delaunay", 0.5, 1024}};
  r.certificate.euler = -4;
  r.certificate.volume = 0.3;
  r.certificate.first_defect = "edge 1-2 has \"3\" triangles";
  r.warnings = {"'b\xFF.ply': odd name"};
  return r;
}

TEST(ReportJson, HoldsEveryFieldInOrder) {
  const std::string text = to_json(full_report());
  const Json json = Json::parse(text);
  EXPECT_EQ(keys(json), (std::vector<std::string>{"version",
                                                  "options",
                                                  "threads",
                                                  "input_points",
                                                  "non_finite_points",
                                                  "duplicate_points",
                                                  "outliers_removed",
                                                  "samples",
                                                  "background_points",
                                                  "feature_points",
                                                  "refine_points",
                                                  "tetrahedra",
                                                  "free_tetrahedra",
                                                  "surface_samples",
                                                  "shift",
                                                  "scale",
                                                  "spacing",
                                                  "contradiction",
                                                  "cut_energy",
                                                  "swap_energy",
                                                  "swaps",
                                                  "manifold_flips",
                                                  "specks",
                                                  "noise_median",
                                                  "noise_highest",
                                                  "moved_samples",
                                                  "filled_faces",
                                                  "filled_area",
                                                  "trimmed",
                                                  "features",
                                                  "stages",
                                                  "certificate",
                                                  "warnings"}));
  EXPECT_EQ(keys(json["options"]),
            (std::vector<std::string>{"method", "lambda", "cycles", "background", "curvature",
                                      "swap", "keep_samples", "tetrahedra", "sharpen", "refine",
                                      "trim", "non_finite", "outliers", "noise"}));
  EXPECT_EQ(keys(json["certificate"]), (std::vector<std::string>{"ok",
                                                                 "sound",
                                                                 "closed",
                                                                 "manifold",
                                                                 "oriented",
                                                                 "vertices",
                                                                 "triangles",
                                                                 "edges",
                                                                 "invalid_indices",
                                                                 "non_finite_vertices",
                                                                 "unreferenced_vertices",
                                                                 "degenerate_triangles",
                                                                 "boundary_edges",
                                                                 "nonmanifold_edges",
                                                                 "nonmanifold_vertices",
                                                                 "misoriented_edges",
                                                                 "intersecting_pairs",
                                                                 "inward_components",
                                                                 "components",
                                                                 "euler",
                                                                 "volume",
                                                                 "area",
                                                                 "first_defect"}));
}

TEST(ReportJson, KeepsValues) {
  const Report report = full_report();
  const Json json = Json::parse(to_json(report));
  EXPECT_EQ(json["version"], ARRIS_VERSION);
  EXPECT_EQ(json["options"]["method"], "paper");
  EXPECT_EQ(json["options"]["curvature"], "cotangent");
  EXPECT_EQ(json["options"]["non_finite"], "drop");
  EXPECT_EQ(json["options"]["outliers"], "keep");
  EXPECT_EQ(json["outliers_removed"]["stray"], 7);
  EXPECT_EQ(json["outliers_removed"]["surface"], 2);
  EXPECT_EQ(json["options"]["lambda"].get<double>(), 0.1);
  EXPECT_EQ(json["options"]["swap"], true);
  EXPECT_EQ(json["input_points"].get<std::uint64_t>(), report.input_points);
  EXPECT_EQ(json["shift"].get<std::vector<double>>(), (std::vector<double>{1.5, -2.5, 1e300}));
  EXPECT_EQ(json["cut_energy"].get<std::vector<double>>(), report.cut_energy);
  EXPECT_EQ(json["swap_energy"].size(), 0u);
  EXPECT_TRUE(json["swap_energy"].is_array());
  EXPECT_EQ(json["filled_area"].get<double>(), 0.25);
  EXPECT_EQ(json["trimmed"], true);
  EXPECT_EQ(keys(json["features"]),
            (std::vector<std::string>{"curves", "closed_curves", "convex_curves", "concave_curves",
                                      "corners", "ends", "patches", "length"}));
  EXPECT_EQ(json["features"]["curves"], 12);
  EXPECT_EQ(json["features"]["length"].get<double>(), 1.5);
  EXPECT_EQ(json["stages"][0]["name"], "delaunay");
  EXPECT_EQ(json["stages"][0]["peak_memory"], 1024);
  EXPECT_EQ(json["certificate"]["ok"], false);
  EXPECT_EQ(json["certificate"]["euler"], -4);
  EXPECT_EQ(json["certificate"]["first_defect"], report.certificate.first_defect);
  EXPECT_EQ(json["warnings"][0], "'b\xEF\xBF\xBD.ply': odd name");
}

TEST(ReportJson, IsTheSameTextEveryTime) {
  const std::string text = to_json(full_report());
  EXPECT_EQ(text, to_json(full_report()));
  EXPECT_TRUE(text.starts_with("{\n  \"version\": "));
  EXPECT_TRUE(text.ends_with("}\n"));
}

}  // namespace
}  // namespace arris::test
