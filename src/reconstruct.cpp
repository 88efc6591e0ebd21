// The whole pipeline on one page: samples → tetrahedra → seeds → cut → swap → features, cut again →
// surface.
#include "arris/reconstruct.h"

#include <algorithm>
#include <utility>

#include "base/failure.h"
#include "base/job.h"
#include "base/vec.h"
#include "cloud/outliers.h"
#include "cloud/prepare.h"
#include "cut/level_set.h"
#include "cut/surface_cut.h"
#include "describe.h"
#include "feature/spikes.h"
#include "feature_stage.h"
#include "forecast.h"
#include "handles_stage.h"
#include "noise_stage.h"
#include "options.h"
#include "output.h"
#include "refine_stage.h"
#include "seed/seeds.h"
#include "seed/transfer.h"
#include "stage.h"
#include "surface/certify.h"
#include "surface/extract.h"
#include "tetra/background.h"
#include "tetra/delaunay.h"
#include "tetra/geometry.h"

namespace arris {
namespace {

// Shares of the whole time, for the progress bar; measured at 200,000 points and more.
struct Shares {
  double samples, outliers, noise, delaunay, seeds, background, cut, swap, features, refine, check;
};
constexpr Shares automatic_shares = {0.01, 0.03, 0.04, 0.07, 0.04, 0, 0.04, 0.11, 0.43, 0.05, 0.07};
constexpr Shares refine_shares = {0.01, 0.02, 0.02, 0.03, 0.02, 0, 0.01, 0.04, 0.20, 0.61, 0.04};
constexpr Shares paper_shares = {0.01, 0, 0, 0.04, 0.02, 0.45, 0.25, 0.15, 0, 0, 0.03};
constexpr Shares not_foreseen = {};  // of what is done once more

// The share of the noise that moving the samples leaves in them, measured on flat and curved
// shapes; and that by which settled samples are off the smooth surface that their neighbours agree
// on: wider tolerances would let patches creep round edges of 40 degrees.
constexpr double left_of_noise = 0.25, left_when_settled = 0.05;

// In units of spacing: noise of less than this leaves a first surface so smooth that settling
// before the edges are known would only blunt them, noise of more than that one so rough that
// samples settle better on the second.
constexpr double shallow_noise = 0.1, deep_noise = 0.25;

// Corners are sensed better once their edges are there.
constexpr int feature_rounds = 2;

// A spike can hide another, rarely a third.
constexpr int most_spike_rounds = 2;

Stage seed_samples(const Samples& samples, const Options& options, const Shares& shares, Job& job) {
  Stage stage;
  job.stage("delaunay", shares.delaunay);
  stage.mesh = delaunay(samples.points, samples.points.size(), job);
  job.stage("seeds", shares.seeds);
  stage.stars = Stars(stage.mesh);
  stage.model.lambda = options.lambda;
  stage.model.curvature = options.curvature;
  stage.model.spacing = sample_spacing(stage.mesh, stage.stars, job.threads());
  const std::vector<Circumball> balls = circumballs(stage.mesh, job.threads());
  stage.seeds = find_seeds(stage.mesh, stage.stars, balls, stage.model.spacing, job);
  return stage;
}

// Delaunay of samples and background points, with the seeds of the samples alone (paper, section
// 3).
Stage add_background(const Stage& coarse, const Samples& samples, const Options& options,
                     const Shares& shares, Report& report, Job& job) {
  job.stage("background", shares.background);
  const SurfaceCut first = cut_surface(coarse.mesh, coarse.model, coarse.seeds, {}, job);
  const Background background = background_points(samples.points, coarse.model.spacing,
                                                  samples.frame, options.background, job);
  report.background_points = background.points.size();
  std::vector<Vec3> points = samples.points;
  points.insert(points.end(), background.points.begin(), background.points.end());
  Stage fine;
  fine.mesh = delaunay(std::move(points), samples.points.size(), job);
  fine.stars = Stars(fine.mesh);
  fine.mesh.nearest = nearest_samples(samples.points.size(), background);
  fine.model = coarse.model;
  for (Index near : background.nearest) fine.model.spacing.push_back(coarse.model.spacing[near]);
  fine.seeds = transfer_seeds(coarse.mesh, first.labels, coarse.seeds, fine.mesh, job);
  return fine;
}

// All that the cut needs.
Stage make_stage(const Samples& samples, const Options& options, const Shares& shares,
                 Report& report, Job& job) {
  Stage stage = seed_samples(samples, options, shares, job);
  if (options.background > 0) stage = add_background(stage, samples, options, shares, report, job);
  return stage;
}

// Removes the samples that the surface shows to be outliers; returns how many.
std::uint64_t drop_spikes(const Stage& stage, const Labels& labels, Samples& samples, Job& job) {
  return drop_samples(samples,
                      find_spikes(stage.mesh.points, boundary_triangles(stage.mesh, labels),
                                  stage.model.spacing, job));
}

// The paper's iteration: κ^0 = 0, then κ^n from the signed distance to Γ^n (eq. 6).
Labels iterate_cuts(const Stage& stage, int cycles, double share, Report& report, Job& job) {
  report.cut_energy.clear();
  report.manifold_flips = 0;
  std::vector<double> curvature;
  Labels labels;
  for (int n = 0; n < cycles; ++n) {
    job.stage(cycles == 1 ? "cut" : "cut " + std::to_string(n + 1), share / cycles);
    if (n > 0)
      curvature =
          level_set_curvature(stage.mesh, signed_distance(stage.mesh, stage.stars, labels, job));
    SurfaceCut cut = cut_manifold(stage, curvature, report, job);
    report.cut_energy.push_back(cut.energy);
    report.free_tetrahedra = cut.free;
    labels = std::move(cut.labels);
  }
  return labels;
}

// Features that no sample marks (docs/method.md): points are added where the sensed surfaces meet,
// and the surface is cut anew round them, until there is nothing to add. The rounds between the
// first and the last surface go without swaps.
void sharpen(const Samples& samples, const Options& options, int rounds, const Shares& shares,
             Stage& stage, Labels& labels, Report& report, Job& job) {
  std::vector<FeaturePoint> features;
  for (int round = 1; round <= rounds; ++round) {
    job.stage("features " + std::to_string(round), shares.features / rounds);
    if (!add_features(samples, stage, labels, features, report, job)) break;
  }
  report.feature_points = features.size();
  job.stage("swap again", shares.swap);
  if (options.swap && report.feature_points > 0) run_swaps(stage, labels, report, job);
}

void require_inside(const Labels& labels) {
  if (!has_inside(labels))
    throw Failure(ErrorCode::no_surface, "the points do not enclose a volume: nothing is inside",
                  "scan the object from more sides, or give more points");
}

// Joins what missing samples have parted, and swaps.
void finish_first(const Samples& samples, const Options& options, double share, Stage& stage,
                  Labels& labels, Report& report, Job& job) {
  require_inside(labels);
  if (stage.mesh.points.size() == samples.points.size()) join_parts(stage, labels, report, job);
  forget_evidence(stage);
  job.stage("swap", share);
  if (options.swap) run_swaps(stage, labels, report, job);
}

struct NoisyCloud {
  const PointCloud& cloud;
  Noise noise;
  double level = 0;  // its median, in the local frame
};

// Settles the samples on their surface and makes a new one.
void settle_again(const NoisyCloud& data, Settling how, const Options& options, Samples& samples,
                  Stage& stage, Labels& labels, Report& report, Job& job) {
  job.stage("settle", 0);
  settle(data.cloud, data.noise, stage, labels, how, samples, job);
  stage = {};  // two at a time would be the peak of memory
  stage = make_stage(samples, options, not_foreseen, report, job);
  labels = iterate_cuts(stage, options.cycles, not_foreseen.cut, report, job);
  finish_first(samples, options, not_foreseen.swap, stage, labels, report, job);
  stage.roughness = left_when_settled * data.level;
}

// Before the features are known: once, or twice where the noise is deep, or not at all.
void settle_first(const NoisyCloud& data, const Options& options, Samples& samples, Stage& stage,
                  Labels& labels, Report& report, Job& job) {
  std::vector<double> spacing = stage.model.spacing;
  const auto middle = spacing.begin() + static_cast<std::ptrdiff_t>(spacing.size() / 2);
  std::nth_element(spacing.begin(), middle, spacing.end());
  stage.roughness = left_of_noise * data.level;
  if (data.level < shallow_noise * *middle) return;
  const bool deep = data.level > deep_noise * *middle;
  settle_again(data, Settling::means, options, samples, stage, labels, report, job);
  if (deep) settle_again(data, Settling::patches, options, samples, stage, labels, report, job);
}

void require_attributes(const PointCloud& cloud) {
  for (const Attribute& a : cloud.attributes)
    if (a.values.size() != cloud.positions.size())
      throw Failure(ErrorCode::usage,
                    "attribute '" + a.name + "' has " + std::to_string(a.values.size()) +
                        " values for " + std::to_string(cloud.positions.size()) + " points",
                    "give one value per point");
}

Reconstruction run(const PointCloud& cloud, const Options& given, const Context& context) {
  Job job(context);
  Reconstruction result;
  Report& report = result.report;
  const Options options = report.options = resolve_options(given);
  require_attributes(cloud);
  require_memory(cloud.positions.size(), options, context);
  const Shares& shares = options.background > 0 ? paper_shares
                         : options.refine       ? refine_shares
                                                : automatic_shares;

  job.stage("samples", shares.samples);
  Samples samples = prepare_samples(cloud.positions, options.non_finite, job);
  if (options.outliers == Outliers::drop) {
    job.stage("outliers", shares.outliers);
    report.stray_outliers = drop_samples(samples, find_outliers(samples.points, job));
  }
  NoisyCloud noisy{cloud, {}, 0};
  if (options.noise != 0) {
    job.stage("noise", shares.noise);
    noisy.noise = remove_noise(cloud, options, samples, report, job);
    noisy.level = report.noise_median * samples.frame.scale;
  }
  const bool has_noise = !noisy.noise.level.empty();
  Stage stage = make_stage(samples, options, shares, report, job);
  Labels labels = iterate_cuts(stage, options.cycles, shares.cut, report, job);
  for (int round = 0; options.outliers == Outliers::drop && round < most_spike_rounds; ++round) {
    const std::uint64_t dropped = drop_spikes(stage, labels, samples, job);
    if (dropped == 0) break;
    report.surface_outliers += dropped;
    stage = {};
    stage = make_stage(samples, options, not_foreseen, report, job);
    labels = iterate_cuts(stage, options.cycles, not_foreseen.cut, report, job);
  }
  finish_first(samples, options, shares.swap, stage, labels, report, job);
  if (has_noise) settle_first(noisy, options, samples, stage, labels, report, job);
  if (options.sharpen && has_noise) {  // known edges let samples settle better, and these the edges
    sharpen(samples, options, 1, not_foreseen, stage, labels, report, job);
    settle_again(noisy, Settling::patches, options, samples, stage, labels, report, job);
  }
  if (options.background == 0) mend_handles(stage, labels, report, job);
  if (options.sharpen) {
    const Topology before = topology_of(stage.mesh, labels);
    sharpen(samples, options, feature_rounds, shares, stage, labels, report, job);
    if (topology_of(stage.mesh, labels) != before) mend_handles(stage, labels, report, job);
  }
  if (options.refine) {
    job.stage("refine", shares.refine);
    report.refine_points = refine_surface(samples, stage, labels, report, job);
  } else if (options.sharpen) {
    job.stage("gaps", shares.refine);
    report.refine_points = fill_gaps(samples, stage, labels, report, job);
  }
  stage.mesh.samples = samples.points.size();

  job.stage("check", shares.check);
  fill_counts(cloud, samples, stage.mesh, stage.model.spacing, stage.seeds, report);
  result.mesh = output_mesh(cloud, samples, stage.mesh, labels);
  result.confidence = output_confidence(result.mesh, samples, stage.seeds);
  report.surface_samples = static_cast<std::uint64_t>(std::count_if(
      result.mesh.source.begin(), result.mesh.source.end(), [](Index s) { return s != no_index; }));
  if (options.tetrahedra) result.volume = output_volume(cloud, samples, stage.mesh, labels);
  report.certificate = certify(result.mesh, job);
  if (!report.certificate.ok())
    throw Failure(ErrorCode::certificate,
                  "the mesh failed its check: " + report.certificate.first_defect,
                  "please report it with the input");
  describe_surface(samples, stage.model.spacing, result, job);
  job.finish();
  report.threads = job.threads();
  report.stages = job.stages();
  return result;
}

}  // namespace

Result<Reconstruction> reconstruct(const PointCloud& cloud, const Options& options,
                                   const Context& context) {
  return guarded([&] { return run(cloud, options, context); });
}

}  // namespace arris
