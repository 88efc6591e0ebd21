#include <nlohmann/json.hpp>

#include "compare/compare.h"

namespace arris::compare {
namespace {

using Json = nlohmann::ordered_json;  // writes NaN as null

Json to_object(const Score& s) {
  return {{"precision", s.precision}, {"recall", s.recall}, {"f1", s.f1}};
}

Json to_object(const Directed& d) {
  return {{"mean", d.mean},
          {"rms", d.rms},
          {"p99", d.p99},
          {"max", d.max},
          {"normal_error_deg", d.normal_error},
          {"normal_error_oriented_deg", d.normal_error_oriented},
          {"normal_error_above_15_deg", d.normal_bad}};
}

Json to_object(const FeatureScore& f) {
  Json corners = to_object(f.corners);
  corners["count_result"] = f.corners_result;
  corners["count_truth"] = f.corners_truth;
  return {{"dihedral_deg", f.dihedral},       {"at_0.005", to_object(f.loose)},
          {"at_0.001", to_object(f.strict)},  {"chamfer", f.chamfer},
          {"length_result", f.length_result}, {"length_truth", f.length_truth},
          {"corners", std::move(corners)}};
}

Json to_object(const NdcScore& n) {
  return {{"ef1", n.edge.f1},
          {"precision", n.edge.precision},
          {"recall", n.edge.recall},
          {"ecd", n.chamfer},
          {"edge_points_result", n.points_result},
          {"edge_points_truth", n.points_truth}};
}

Json to_object(const MeshFacts& facts) {
  const Certificate& c = facts.certificate;
  return {{"vertices", c.vertices},
          {"triangles", c.triangles},
          {"components", c.components},
          {"euler", c.euler},
          {"genus", facts.genus ? Json(*facts.genus) : Json(nullptr)},
          {"closed", c.closed()},
          {"manifold", c.manifold()},
          {"oriented", c.oriented()},
          {"boundary_edges", c.boundary_edges},
          {"odd_edges", facts.odd_edges},
          {"nonmanifold_edges", c.nonmanifold_edges},
          {"nonmanifold_vertices", c.nonmanifold_vertices},
          {"degenerate_triangles", c.degenerate_triangles},
          {"self_intersections", c.intersecting_pairs},
          {"volume", c.volume},
          {"area", c.area}};
}

}  // namespace

std::string to_json(const Comparison& c) {
  Json sweep = Json::array();
  for (const FeatureScore& f : c.sweep) sweep.push_back(to_object(f));
  const Json json = {
      {"diagonal", c.diagonal},
      {"samples", c.samples},
      {"chamfer", c.chamfer},
      {"hausdorff", c.hausdorff},
      {"rms", c.rms},
      {"fscore_0.005", to_object(c.loose)},
      {"fscore_0.001", to_object(c.strict)},
      {"normal_error_deg", c.result_to_truth.normal_error},
      {"volume_iou", c.volume_iou},
      {"same_topology", c.same_topology},
      {"edges", to_object(c.features)},
      {"edges_sweep", std::move(sweep)},
      {"ndc", to_object(c.ndc)},
      {"result_to_truth", to_object(c.result_to_truth)},
      {"truth_to_result", to_object(c.truth_to_result)},
      {"result", to_object(c.result)},
      {"truth", to_object(c.truth)},
      {"notes", c.notes},
  };
  return json.dump(2) + "\n";
}

}  // namespace arris::compare
