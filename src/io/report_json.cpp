// The report as JSON. Of the library only src/io knows JSON.
#include <nlohmann/json.hpp>

#include "arris/report.h"
#include "arris/version.h"

namespace arris {
namespace {

using Json = nlohmann::ordered_json;

const char* text(Method method) {
  switch (method) {
    case Method::automatic:
      return "automatic";
    case Method::paper:
      return "paper";
  }
  return "unknown";
}

const char* text(Curvature curvature) {
  switch (curvature) {
    case Curvature::by_method:
      return "by_method";
    case Curvature::cotangent:
      return "cotangent";
    case Curvature::polyhedral:
      return "polyhedral";
    case Curvature::area:
      return "area";
  }
  return "unknown";
}

const char* text(NonFinite non_finite) {
  switch (non_finite) {
    case NonFinite::refuse:
      return "refuse";
    case NonFinite::drop:
      return "drop";
  }
  return "unknown";
}

const char* text(Outliers outliers) {
  switch (outliers) {
    case Outliers::by_method:
      return "by_method";
    case Outliers::drop:
      return "drop";
    case Outliers::keep:
      return "keep";
  }
  return "unknown";
}

Json to_object(const Options& o) {
  return {{"method", text(o.method)},
          {"lambda", o.lambda},
          {"cycles", o.cycles},
          {"background", o.background},
          {"curvature", text(o.curvature)},
          {"swap", o.swap},
          {"keep_samples", o.keep_samples},
          {"tetrahedra", o.tetrahedra},
          {"sharpen", o.sharpen},
          {"refine", o.refine},
          {"trim", o.trim},
          {"non_finite", text(o.non_finite)},
          {"outliers", text(o.outliers)},
          {"noise", o.noise}};
}

Json to_object(const Certificate& c) {
  return {{"ok", c.ok()},
          {"sound", c.sound()},
          {"closed", c.closed()},
          {"manifold", c.manifold()},
          {"oriented", c.oriented()},
          {"vertices", c.vertices},
          {"triangles", c.triangles},
          {"edges", c.edges},
          {"invalid_indices", c.invalid_indices},
          {"non_finite_vertices", c.non_finite_vertices},
          {"unreferenced_vertices", c.unreferenced_vertices},
          {"degenerate_triangles", c.degenerate_triangles},
          {"boundary_edges", c.boundary_edges},
          {"nonmanifold_edges", c.nonmanifold_edges},
          {"nonmanifold_vertices", c.nonmanifold_vertices},
          {"misoriented_edges", c.misoriented_edges},
          {"intersecting_pairs", c.intersecting_pairs},
          {"inward_components", c.inward_components},
          {"components", c.components},
          {"euler", c.euler},
          {"volume", c.volume},
          {"area", c.area},
          {"first_defect", c.first_defect}};
}

Json to_object(const FeatureCounts& f) {
  return {{"curves", f.curves},
          {"closed_curves", f.closed_curves},
          {"convex_curves", f.convex_curves},
          {"concave_curves", f.concave_curves},
          {"corners", f.corners},
          {"ends", f.ends},
          {"patches", f.patches},
          {"length", f.length}};
}

Json to_array(const std::vector<StageReport>& stages) {
  Json array = Json::array();
  for (const StageReport& s : stages)
    array.push_back(Json{{"name", s.name}, {"seconds", s.seconds}, {"peak_memory", s.peak_memory}});
  return array;
}

}  // namespace

std::string to_json(const Report& r) {
  const Json json = {
      {"version", version()},
      {"options", to_object(r.options)},
      {"threads", r.threads},
      {"input_points", r.input_points},
      {"non_finite_points", r.non_finite_points},
      {"duplicate_points", r.duplicate_points},
      {"outliers_removed", Json{{"stray", r.stray_outliers}, {"surface", r.surface_outliers}}},
      {"samples", r.samples},
      {"background_points", r.background_points},
      {"feature_points", r.feature_points},
      {"refine_points", r.refine_points},
      {"tetrahedra", r.tetrahedra},
      {"free_tetrahedra", r.free_tetrahedra},
      {"surface_samples", r.surface_samples},
      {"shift", Json::array({r.shift.x, r.shift.y, r.shift.z})},
      {"scale", r.scale},
      {"spacing", r.spacing},
      {"contradiction", r.contradiction},
      {"cut_energy", r.cut_energy},
      {"swap_energy", r.swap_energy},
      {"swaps", r.swaps},
      {"manifold_flips", r.manifold_flips},
      {"specks", r.specks},
      {"noise_median", r.noise_median},
      {"noise_highest", r.noise_highest},
      {"moved_samples", r.moved_samples},
      {"filled_faces", r.filled_faces},
      {"filled_area", r.filled_area},
      {"trimmed", r.trimmed},
      {"features", to_object(r.features)},
      {"stages", to_array(r.stages)},
      {"certificate", to_object(r.certificate)},
      {"warnings", r.warnings}};
  // File names in warnings need not be UTF-8: what is not becomes U+FFFD.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace arris
