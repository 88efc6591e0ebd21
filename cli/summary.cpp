#include "summary.h"

#include <cstdio>

#include "text.h"

namespace arris::cli {
namespace {

void line(const char* label, const std::string& value) {
  std::printf("  %-22s %s\n", label, value.c_str());
}

void count(const char* label, std::uint64_t value) {
  line(label, with_commas(value));
}

void energies(const char* label, const std::vector<double>& values) {
  std::string list;
  for (const double value : values)
    list.append(list.empty() ? "" : " ").append(short_number(value));
  if (!list.empty()) line(label, list);
}

// The numbers of dropped and merged points, if any.
std::string left_out(const Report& report) {
  std::string text;
  if (report.duplicate_points > 0)
    text.append(", ").append(counted(report.duplicate_points, "duplicate"));
  if (report.non_finite_points > 0)
    text.append(", ").append(with_commas(report.non_finite_points)).append(" non-finite");
  if (report.stray_outliers + report.surface_outliers > 0)
    text.append(", ").append(counted(report.stray_outliers + report.surface_outliers, "outlier") +
                             " removed");
  return text;
}

}  // namespace

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    std::fprintf(stderr, "arris: warning: %s\n", warning.c_str());
}

void print_summary(const std::string& path, const Report& report, double seconds) {
  const Certificate& mesh = report.certificate;
  std::printf("%s: %s, %s, %s, Euler characteristic %lld\n", path.c_str(),
              counted(mesh.vertices, "vertex").c_str(), counted(mesh.triangles, "face").c_str(),
              counted(mesh.components, "component").c_str(), static_cast<long long>(mesh.euler));
  std::printf("  from         %s%s\n", counted(report.input_points, "point").c_str(),
              left_out(report).c_str());
  if (mesh.ok())
    std::printf("  certificate  closed, manifold, oriented, free of self-intersections\n");
  else if (report.trimmed && mesh.sound())
    std::printf("  certificate  open, manifold, oriented, free of self-intersections\n");
  else
    std::printf("  certificate  FAILED: %s\n", mesh.first_defect.c_str());
  if (report.moved_samples > 0)
    std::printf("  noise        %s (median), %s moved\n", short_number(report.noise_median).c_str(),
                counted(report.moved_samples, "sample").c_str());
  std::printf("  evidence     %s %% contradicts the result\n",
              short_number(100 * report.contradiction).c_str());
  std::printf("  features     %s, %s, %s\n", counted(report.features.curves, "curve").c_str(),
              counted(report.features.corners, "corner").c_str(),
              counted(report.features.patches, "patch").c_str());
  if (report.filled_faces > 0)
    std::printf("  %s      %s, %s %% of the area, close gaps in the samples\n",
                report.trimmed ? "trimmed" : "filled ",
                counted(report.filled_faces, "face").c_str(),
                short_number(100 * report.filled_area).c_str());
  const std::uint64_t peak = report.stages.empty() ? 0 : report.stages.back().peak_memory;
  std::printf("  took         %s, %s at most\n", human_seconds(seconds).c_str(),
              human_bytes(peak).c_str());
}

void print_details(const Report& report) {
  std::printf("details\n");
  count("samples", report.samples);
  count("background points", report.background_points);
  count("feature points", report.feature_points);
  count("refine points", report.refine_points);
  count("tetrahedra", report.tetrahedra);
  count("free tetrahedra", report.free_tetrahedra);
  count("samples on the surface", report.surface_samples);
  line("sample spacing", short_number(report.spacing));
  line("noise, median", short_number(report.noise_median));
  line("noise, highest", short_number(report.noise_highest));
  count("samples moved", report.moved_samples);
  line("lambda", short_number(report.options.lambda));
  count("swaps", report.swaps);
  count("manifold flips", report.manifold_flips);
  count("specks removed", report.specks);
  count("filled faces", report.filled_faces);
  line("filled share of area", short_number(report.filled_area));
  count("closed curves", report.features.closed_curves);
  count("convex curves", report.features.convex_curves);
  count("concave curves", report.features.concave_curves);
  count("curves that fade out", report.features.ends);
  energies("energy after cuts", report.cut_energy);
  energies("energy of swaps", report.swap_energy);
  line("threads", std::to_string(report.threads));
  std::printf("stages\n");
  for (const StageReport& stage : report.stages)
    std::printf("  %-22s %10s %12s\n", stage.name.c_str(), human_seconds(stage.seconds).c_str(),
                human_bytes(stage.peak_memory).c_str());
}

void print_certificate(const std::string& path, const Certificate& c) {
  std::printf("%s: %s\n", path.c_str(),
              c.ok()                     ? "certified"
              : c.sound() && !c.closed() ? "open, sound otherwise"
                                         : "NOT certified");
  count("vertices", c.vertices);
  count("triangles", c.triangles);
  count("edges", c.edges);
  count("components", c.components);
  line("Euler characteristic", std::to_string(c.euler));
  line("volume", short_number(c.volume));
  line("area", short_number(c.area));
  const auto promise = [](const char* label, bool kept, const std::string& defects) {
    line(label, kept ? "yes" : std::string("NO: ").append(defects));
  };
  promise("closed", c.closed(),
          c.triangles == 0 ? "no triangles" : counted(c.boundary_edges, "boundary edge"));
  promise("manifold", c.manifold(),
          counted(c.nonmanifold_edges, "edge") + " and " +
              counted(c.nonmanifold_vertices, "vertex") + " are not");
  promise("oriented", c.oriented(),
          counted(c.misoriented_edges, "edge") + " and " +
              counted(c.inward_components, "component") + " are not");
  promise("no self-intersections", c.intersecting_pairs == 0,
          counted(c.intersecting_pairs, "pair") + " of triangles intersect");
  promise("no degenerate faces", c.degenerate_triangles == 0,
          counted(c.degenerate_triangles, "triangle"));
  promise("volume above zero", c.volume > 0, short_number(c.volume));
  if (c.invalid_indices > 0) count("INVALID INDICES", c.invalid_indices);
  if (c.non_finite_vertices > 0) count("NON-FINITE VERTICES", c.non_finite_vertices);
  if (c.unreferenced_vertices > 0) count("unreferenced vertices", c.unreferenced_vertices);
  if (!c.first_defect.empty()) line("first defect", c.first_defect);
}

}  // namespace arris::cli
