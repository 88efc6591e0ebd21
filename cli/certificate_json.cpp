#include "json_object.h"
#include "summary.h"

namespace arris::cli {

void print_certificate_json(const Certificate& c) {
  JsonObject json;
  json.add("ok", c.ok());
  json.add("closed", c.closed());
  json.add("manifold", c.manifold());
  json.add("oriented", c.oriented());
  json.add("vertices", c.vertices);
  json.add("triangles", c.triangles);
  json.add("edges", c.edges);
  json.add("invalid_indices", c.invalid_indices);
  json.add("non_finite_vertices", c.non_finite_vertices);
  json.add("unreferenced_vertices", c.unreferenced_vertices);
  json.add("degenerate_triangles", c.degenerate_triangles);
  json.add("boundary_edges", c.boundary_edges);
  json.add("nonmanifold_edges", c.nonmanifold_edges);
  json.add("nonmanifold_vertices", c.nonmanifold_vertices);
  json.add("misoriented_edges", c.misoriented_edges);
  json.add("intersecting_pairs", c.intersecting_pairs);
  json.add("inward_components", c.inward_components);
  json.add("components", c.components);
  json.add("euler", c.euler);
  json.add("volume", c.volume);
  json.add("area", c.area);
  json.add("first_defect", c.first_defect);
  json.print();
}

}  // namespace arris::cli
