#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "summary.h"
#include "text.h"

namespace arris::cli {
namespace {

std::string json_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) {
      out += c;
    } else {
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned>(c));
      out += escape.data();
    }
  }
  out += '"';
  return out;
}

std::string json_number(double value) {
  return std::isfinite(value) ? exact_number(value) : "null";  // JSON has no NaN
}

}  // namespace

void print_certificate_json(const Certificate& c) {
  std::string out = "{";
  const auto field = [&](const char* key, const std::string& value) {
    out += out.size() > 1 ? ",\n  \"" : "\n  \"";
    out.append(key).append("\": ").append(value);
  };
  const auto flag = [&](const char* key, bool value) { field(key, value ? "true" : "false"); };
  const auto number = [&](const char* key, std::uint64_t n) { field(key, std::to_string(n)); };
  flag("ok", c.ok());
  flag("closed", c.closed());
  flag("manifold", c.manifold());
  flag("oriented", c.oriented());
  number("vertices", c.vertices);
  number("triangles", c.triangles);
  number("edges", c.edges);
  number("invalid_indices", c.invalid_indices);
  number("non_finite_vertices", c.non_finite_vertices);
  number("unreferenced_vertices", c.unreferenced_vertices);
  number("degenerate_triangles", c.degenerate_triangles);
  number("boundary_edges", c.boundary_edges);
  number("nonmanifold_edges", c.nonmanifold_edges);
  number("nonmanifold_vertices", c.nonmanifold_vertices);
  number("misoriented_edges", c.misoriented_edges);
  number("intersecting_pairs", c.intersecting_pairs);
  number("inward_components", c.inward_components);
  number("components", c.components);
  field("euler", std::to_string(c.euler));
  field("volume", json_number(c.volume));
  field("area", json_number(c.area));
  field("first_defect", json_text(c.first_defect));
  std::printf("%s\n}\n", out.c_str());
}

}  // namespace arris::cli
