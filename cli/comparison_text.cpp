#include "comparison_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "text.h"

namespace arris::cli {
namespace {

using compare::Comparison;
using compare::Directed;
using compare::FeatureScore;
using compare::MeshFacts;
using compare::Score;

std::string number(const char* pattern, double value) {
  if (std::isnan(value)) return "-";
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), pattern, value);
  return buffer.data();
}

std::string length(double value) {
  return number("%.3e", value);
}
std::string share(double value) {
  return number("%.4f", value);
}
std::string degrees(double value) {
  return number("%.2f", value);
}

// `more` says what the last number is.
void row(const char* title, const std::string& a, const std::string& b, const std::string& c = "",
         const char* more = "") {
  std::string line(128, ' ');
  const int length = std::snprintf(line.data(), line.size(), "  %-24s %12s %12s %12s %s", title,
                                   a.c_str(), b.c_str(), c.c_str(), more);
  line.resize(std::min(static_cast<std::size_t>(length), line.size()));
  line.erase(line.find_last_not_of(' ') + 1);
  std::printf("%s\n", line.c_str());
}

void score_row(const char* title, const Score& s) {
  row(title, share(s.precision), share(s.recall), share(s.f1));
}

void print_surfaces(const Comparison& c) {
  const Directed &a = c.result_to_truth, &b = c.truth_to_result;
  row("surfaces", "to truth", "to result", "both");
  row("  mean distance", length(a.mean), length(b.mean), length(c.chamfer), "Chamfer");
  row("  root mean square", length(a.rms), length(b.rms), length(c.rms));
  row("  99 % are nearer than", length(a.p99), length(b.p99));
  row("  largest", length(a.max), length(b.max), length(c.hausdorff), "Hausdorff");
  row("  normal error, degrees", degrees(a.normal_error), degrees(b.normal_error));
  row("", "precision", "recall", "F-score");
  score_row("  within 0.5 %", c.loose);
  score_row("  within 0.1 %", c.strict);
}

void print_edges(const Comparison& c) {
  row("sharp edges", "precision", "recall", "F1");
  const auto print = [](const FeatureScore& f) {
    const std::string turn = "  " + short_number(f.dihedral) + " degrees, ";
    score_row((turn + "0.5 %").c_str(), f.loose);
    score_row((turn + "0.1 %").c_str(), f.strict);
  };
  print(c.features);
  for (const FeatureScore& f : c.sweep)
    if (f.dihedral != c.features.dihedral) print(f);
  score_row("  corners, 0.5 %", c.features.corners);
  score_row("  NDC: EF1", c.ndc.edge);
}

std::string count(std::uint64_t n) {
  return with_commas(n);
}

void print_solids(const Comparison& c) {
  const MeshFacts &r = c.result, &t = c.truth;
  const auto counts = [&](const char* title, std::uint64_t Certificate::*member) {
    row(title, count(r.certificate.*member), count(t.certificate.*member));
  };
  const auto genus = [](const MeshFacts& f) { return f.genus ? std::to_string(*f.genus) : "-"; };
  row("solids", "result", "truth");
  counts("  triangles", &Certificate::triangles);
  counts("  components", &Certificate::components);
  row("  Euler characteristic", std::to_string(r.certificate.euler),
      std::to_string(t.certificate.euler));
  row("  genus", genus(r), genus(t));
  row("  topology", "", "", c.same_topology ? "the same" : "they differ");
  counts("  boundary edges", &Certificate::boundary_edges);
  counts("  non-manifold edges", &Certificate::nonmanifold_edges);
  counts("  self-intersections", &Certificate::intersecting_pairs);
  row("  volume", short_number(r.certificate.volume), short_number(t.certificate.volume),
      share(c.volume_iou), "IoU");
}

}  // namespace

void print_comparison(const std::string& result, const std::string& truth, const Comparison& c) {
  std::printf("%s against %s\n", result.c_str(), truth.c_str());
  std::printf("  lengths are in diagonals of the truth: 1 is %s; %s samples\n",
              short_number(c.diagonal).c_str(), count(c.samples).c_str());
  print_surfaces(c);
  print_edges(c);
  print_solids(c);
  for (const std::string& note : c.notes) std::printf("  note: %s\n", note.c_str());
}

}  // namespace arris::cli
