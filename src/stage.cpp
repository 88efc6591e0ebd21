#include "stage.h"

#include <algorithm>
#include <utility>

#include "base/memory.h"
#include "cut/facet_costs.h"
#include "cut/join.h"
#include "cut/manifold.h"
#include "cut/specks.h"
#include "surface/extract.h"
#include "swap/flat.h"
#include "swap/swap.h"

namespace arris {
namespace {

// Returns how many tetrahedra were flipped.
std::uint64_t make_manifold(const Stage& stage, const std::vector<double>& curvature,
                            Labels& labels, Job& job) {
  return make_manifold(
      stage.mesh, stage.stars,
      [&](Tet t, int i) { return facet_cost(stage.mesh, stage.model, curvature, t, i); }, labels,
      job);
}

}  // namespace

bool has_inside(const Labels& labels) {
  return std::find(labels.begin(), labels.end(), std::uint8_t{1}) != labels.end();
}

void forget_evidence(Stage& stage) {
  stage.stars = {};
  release(stage.seeds.label);
  release(stage.seeds.firm);
  release(stage.seeds.hint);
}

SurfaceCut cut_manifold(const Stage& stage, const std::vector<double>& curvature, Report& report,
                        Job& job) {
  SurfaceCut cut = cut_surface(stage.mesh, stage.model, stage.seeds, curvature, job);
  report.manifold_flips += make_manifold(stage, curvature, cut.labels, job);
  report.specks = remove_specks(stage.mesh, stage.model.spacing, cut.labels);
  return cut;
}

Topology topology_of(const TetMesh& mesh, const Labels& labels) {
  return topology_of(boundary_triangles(mesh, labels), mesh.points.size());
}

void remanifold(const Stage& stage, Labels& labels, Report& report, Job& job) {
  report.manifold_flips += make_manifold(stage, {}, labels, job);
  report.specks += remove_specks(stage.mesh, stage.model.spacing, labels);
}

void join_parts(const Stage& stage, Labels& labels, Report& report, Job& job) {
  Labels joined = labels;
  const std::size_t joins = join_stumps(stage.mesh, stage.model.spacing, joined, job);
  if (joins == 0) return;
  Report trial = report;
  remanifold(stage, joined, trial, job);
  const auto lost = static_cast<std::int64_t>(2 * joins);
  if (topology_of(stage.mesh, joined).euler != topology_of(stage.mesh, labels).euler - lost) return;
  report = std::move(trial);
  labels = std::move(joined);
}

void run_swaps(const Stage& stage, Labels& labels, Report& report, Job& job) {
  SwapOptions options;
  options.keep_samples = report.options.keep_samples;
  options.settled = stage.settled;
  options.frozen = flat_tetrahedra(stage.mesh, stage.model.spacing, job.threads());
  SwapResult swaps = swap_tetrahedra(stage.mesh, stage.model, options, labels, job);
  report.swap_energy = std::move(swaps.energy);
  report.swaps = swaps.accepted;
}

}  // namespace arris
