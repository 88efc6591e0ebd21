// Time of the swap stage on a bumpy sphere of 10k, 100k and 1M samples (or the sizes given).
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "energy/curvature.h"
#include "swap/labelling.h"
#include "swap/solids.h"
#include "swap/swap.h"
#include "tetra/delaunay.h"

namespace arris {
namespace {

// Processor time: the stage runs on one core, and other work on the machine does not count.
double seconds_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// Interleaves the bits of the coordinates in [-2, 2): neighbours in space are neighbours in order.
std::uint64_t morton_code(Vec3 p) {
  constexpr int bits = 20;
  std::uint64_t code = 0;
  for (double x : {p.x, p.y, p.z}) {
    const auto cell = static_cast<std::uint64_t>((x + 2) / 4 * (1 << bits));
    for (int b = 0; b < bits; ++b) code |= (cell >> b & 1u) << (3 * b);
    code <<= 1;
  }
  return code;
}

void measure(std::size_t n, Curvature curvature) {
  test::Solid solid = test::bumpy_ball(n, 1);
  std::sort(solid.samples.begin(), solid.samples.end(),
            [](Vec3 a, Vec3 b) { return morton_code(a) < morton_code(b); });
  const Context context;
  Job job(context);
  job.stage("swap", 1);
  const TetMesh mesh = delaunay(solid.samples, n, job);
  Labels labels = test::grow_ball(mesh, solid);
  EnergyModel model;
  model.curvature = curvature;
  model.spacing.assign(n, solid.spacing);
  const double before = total_mean_curvature(mesh, labels);
  auto start = std::clock();
  const double energy = total_energy(mesh, model, labels);
  const double energy_time = seconds_since(start);
  start = std::clock();
  const SwapResult result = swap_tetrahedra(mesh, model, {}, labels, job);
  const double time = seconds_since(start);
  std::printf(
      "%8zu samples %9zu tetrahedra %-10s  energy %.2f s  swap %.2f s  moves %llu  "
      "E %.6g -> %.6g  curvature %.4f -> %.4f\n",
      n, mesh.finite, curvature == Curvature::cotangent ? "cotangent" : "polyhedral", energy_time,
      time, static_cast<unsigned long long>(result.accepted), energy, result.energy.back(), before,
      total_mean_curvature(mesh, labels));
  std::fflush(stdout);
}

}  // namespace
}  // namespace arris

int main(int argc, char** argv) {
  std::vector<std::size_t> sizes = {10'000, 100'000, 1'000'000};
  if (argc > 1) sizes.clear();
  for (int k = 1; k < argc; ++k) sizes.push_back(std::strtoul(argv[k], nullptr, 10));
  for (std::size_t n : sizes)
    for (auto curvature : {arris::Curvature::polyhedral, arris::Curvature::cotangent})
      arris::measure(n, curvature);
}
