// How time and memory of the default pipeline grow, and the ratio to CGAL's sequential Delaunay of
// the same points in the same run.
//
//   scaling_bench N [--paper]         one line of JSON
//   scaling_bench N --fan             the same for two tips over a ring, with N facets each
//   scaling_bench N --write FILE.ply  the points alone, for the peers
//
// The speed suite of bench/benchmark.py runs it over sizes.
//
// Samples lie at random on a bumpy sphere, in random order.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <arris/arris.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

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

// A dense ring and a tip on either side of it, turned so that no plane or line of it is parallel to
// an axis: vertices of as many facets as there are points.
std::vector<arris::Vec3> fan(std::size_t n) {
  std::vector<arris::Vec3> points = {{0, 0, 1}, {0, 0, -1.3}};
  for (std::size_t k = 0; k < n; ++k) {
    const double a = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    points.push_back({std::cos(a), std::sin(a), 0});
  }
  for (arris::Vec3& p : points) {
    const double x = 0.6 * p.x - 0.8 * p.y, y = 0.8 * p.x + 0.6 * p.y;
    p = {x, 0.6 * y - 0.8 * p.z, 0.8 * y + 0.6 * p.z};
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

// One line of JSON: times and memory of arris, stage by stage, and the time of CGAL.
void print(std::size_t n, const arris::Reconstruction& result, double cgal_seconds) {
  std::printf("{\"points\": %zu, \"stages\": [", n);
  const char* separator = "";
  for (const arris::StageReport& stage : result.report.stages) {
    std::printf("%s{\"name\": \"%s\", \"seconds\": %.6f, \"peak_memory\": %llu}", separator,
                stage.name.c_str(), stage.seconds,
                static_cast<unsigned long long>(stage.peak_memory));
    separator = ", ";
  }
  std::printf("], \"triangles\": %zu, \"cgal_delaunay_seconds\": %.6f}\n",
              result.mesh.triangles.size(), cgal_seconds);
}

int fail(const arris::Error& error) {
  std::fprintf(stderr, "scaling_bench: %s\n", error.message.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t n = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10000;
  const std::string option = argc > 2 ? argv[2] : "";
  if (option == "--write" && argc > 3) {
    arris::Mesh points;  // without faces: its vertices are written
    points.vertices = bumpy_sphere(n);
    const arris::Result<void> written = arris::write_mesh(argv[3], points);
    return written ? 0 : fail(written.error());
  }
  arris::PointCloud cloud;
  cloud.positions = option == "--fan" ? fan(n) : bumpy_sphere(n);
  arris::Options options;
  if (option == "--fan") options.outliers = arris::Outliers::keep;  // the tips are not
  if (option == "--paper") options.method = arris::Method::paper;
  const arris::Result<arris::Reconstruction> result = arris::reconstruct(cloud, options);
  if (!result) return fail(result.error());
  print(n, *result, cgal_delaunay_seconds(cloud.positions));
  return 0;
}
