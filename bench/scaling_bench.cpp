// How time and memory of the default pipeline grow, and the ratio to CGAL's sequential Delaunay of
// the same points in the same run.
//
//   scaling_bench N [--paper]      one line; bench/scaling.sh prints the table over sizes
//
// Samples lie at random on a bumpy sphere, in random order.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <arris/arris.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numbers>

#include "truth/random.h"

namespace {

std::vector<arris::Vec3> bumpy_sphere(std::size_t n) {
  arris::truth::Random random(1);
  std::vector<arris::Vec3> points(n);
  for (arris::Vec3& p : points) {
    const double z = 2 * random.unit() - 1, a = 2 * std::numbers::pi * random.unit();
    const double s = std::sqrt(1 - z * z), x = s * std::cos(a), y = s * std::sin(a);
    const double r = 1 + 0.2 * std::sin(5 * x) * std::cos(4 * y) * std::sin(3 * z);
    p = {r * x, r * y, r * z};
  }
  return points;
}

double cgal_delaunay_seconds(const std::vector<arris::Vec3>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> input;
  for (const arris::Vec3& p : points) input.emplace_back(p.x, p.y, p.z);
  const auto start = std::chrono::steady_clock::now();
  const CGAL::Delaunay_triangulation_3<Kernel> triangulation(input.begin(), input.end());
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t n = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10000;
  arris::PointCloud cloud;
  cloud.positions = bumpy_sphere(n);
  arris::Options options;
  if (argc > 2 && std::strcmp(argv[2], "--paper") == 0) options.method = arris::Method::paper;
  const arris::Result<arris::Reconstruction> r = arris::reconstruct(cloud, options);
  if (!r) {
    std::fprintf(stderr, "scaling_bench: %s\n", r.error().message.c_str());
    return 1;
  }
  const double cgal = cgal_delaunay_seconds(cloud.positions);
  double to_cut = 0, swap = 0, all = 0;
  std::uint64_t memory = 0;
  std::printf("%9zu", n);
  for (const arris::StageReport& stage : r->report.stages) {
    std::printf("  %s %.3f", stage.name.c_str(), stage.seconds);
    all += stage.seconds;
    if (stage.name == "swap") swap = stage.seconds;
    if (stage.name != "swap" && stage.name != "check") to_cut += stage.seconds;
    memory = std::max(memory, stage.peak_memory);
  }
  std::printf(
      "  | CGAL %.3f  to cut/CGAL %.2f  swap/CGAL %.2f  all/CGAL %.2f  us/point %.2f  "
      "B/point %.0f  faces %zu\n",
      cgal, to_cut / cgal, swap / cgal, all / cgal, 1e6 * all / static_cast<double>(n),
      static_cast<double>(memory) / static_cast<double>(n), r->mesh.triangles.size());
  return 0;
}
