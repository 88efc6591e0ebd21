// How time and memory of the default pipeline grow, and the ratio to CGAL's sequential Delaunay of
// the same points in the same run.
//
//   scaling_bench N [--paper]         one line of JSON
//   scaling_bench N --to-cut [RUNS]   processor time of one thread for all that the default does
//                                     before the first swap, and that of CGAL: medians of RUNS (3)
//   scaling_bench N --fan             the same for two tips over a ring, with N facets each
//   scaling_bench N --write FILE.ply  the points alone, for the peers
//
// The speed suite of bench/benchmark.py runs it over sizes.
//
// Samples lie at random on a bumpy sphere, in random order.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <arris/arris.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <string>
#include <string_view>
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

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Of the whole process.
double processor_seconds() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double cgal_delaunay_seconds(const std::vector<arris::Vec3>& points, double (*clock)()) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> input;
  for (const arris::Vec3& p : points) input.emplace_back(p.x, p.y, p.z);
  const double start = clock();
  const CGAL::Delaunay_triangulation_3<Kernel> triangulation(input.begin(), input.end());
  return clock() - start;
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

struct StageTime {
  std::string name;
  double seconds = 0;
};

// Processor time of the stages before the first swap, on one thread, with all defaults on: the run
// is cancelled there.
std::vector<StageTime> times_to_cut(const arris::PointCloud& cloud) {
  std::vector<StageTime> stages;
  std::atomic<bool> stop = false;
  double last = processor_seconds();
  arris::Context context;
  context.threads = 1;
  context.cancel = &stop;
  context.progress = [&](std::string_view stage, double) {
    const double now = processor_seconds();
    if (!stages.empty()) stages.back().seconds += now - last;
    last = now;
    if (stage == "swap")
      stop = true;
    else if (stages.empty() || stages.back().name != stage)
      stages.push_back({std::string(stage), 0});
  };
  (void)arris::reconstruct(cloud, {}, context);
  return stages;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// One line of JSON: medians of so many runs, CGAL and arris by turns.
void print_to_cut(const arris::PointCloud& cloud, std::size_t runs) {
  std::vector<std::vector<StageTime>> all;
  std::vector<double> cgal, whole, ratio;
  for (std::size_t k = 0; k < runs; ++k) {
    cgal.push_back(cgal_delaunay_seconds(cloud.positions, processor_seconds));
    all.push_back(times_to_cut(cloud));
    double sum = 0;
    for (const StageTime& stage : all.back()) sum += stage.seconds;
    whole.push_back(sum);
    ratio.push_back(sum / cgal.back());
  }
  std::printf("{\"points\": %zu, \"stages\": [", cloud.positions.size());
  for (std::size_t s = 0; s < all[0].size(); ++s) {
    std::vector<double> seconds;
    for (const auto& stages : all) seconds.push_back(stages[s].seconds);
    std::printf("%s{\"name\": \"%s\", \"seconds\": %.6f}", s > 0 ? ", " : "",
                all[0][s].name.c_str(), median(seconds));
  }
  std::printf("], \"to_cut_seconds\": %.6f, \"cgal_delaunay_seconds\": %.6f, \"ratio\": %.3f}\n",
              median(whole), median(cgal), median(ratio));
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
  if (option == "--to-cut") {
    print_to_cut(cloud, argc > 3 ? std::max(1ULL, std::strtoull(argv[3], nullptr, 10)) : 3);
    return 0;
  }
  arris::Options options;
  if (option == "--fan") options.outliers = arris::Outliers::keep;  // the tips are not
  if (option == "--paper") options.method = arris::Method::paper;
  const arris::Result<arris::Reconstruction> result = arris::reconstruct(cloud, options);
  if (!result) return fail(result.error());
  print(n, *result, cgal_delaunay_seconds(cloud.positions, wall_seconds));
  return 0;
}
