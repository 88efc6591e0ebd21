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
#include "feature/facets.h"
#include "feature/settle.h"
#include "feature/spikes.h"
#include "forecast.h"
#include "noise/denoise.h"
#include "options.h"
#include "output.h"
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

// Shares of the whole time, for the progress bar; measured at a million points.
struct Shares {
  double samples, outliers, noise, delaunay, seeds, background, cut, swap, features, check;
};
constexpr Shares automatic_shares = {0.01, 0.02, 0.04, 0.10, 0.04, 0, 0.03, 0.13, 0.40, 0.03};
constexpr Shares paper_shares = {0.01, 0, 0, 0.04, 0.02, 0.45, 0.25, 0.15, 0, 0.03};

// The share of the noise that moving the samples leaves in them, measured on flat and curved
// shapes; and that by which settled samples are off the smooth surface that their neighbours agree
// on: wider tolerances would let patches creep round edges of 40 degrees.
constexpr double left_of_noise = 0.25, left_when_settled = 0.05;

// In units of spacing: noise of less than this leaves a first surface so smooth that settling would
// only blunt its edges, noise of more than that one so rough that samples settle better on the
// second.
constexpr double shallow_noise = 0.1, deep_noise = 0.25;

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

// Per input point: the deviation of its noise, and how many samples its new place is the mean of.
struct Noise {
  std::vector<double> level, backing;
};

// Moves the samples onto the surface that they were measured of. Empty if no sample moved.
Noise remove_noise(const PointCloud& cloud, const Options& options, double share, Samples& samples,
                   Report& report, Job& job) {
  job.stage("noise", share);
  const double scale = samples.frame.scale;
  Denoised clean = denoise(samples.points, options.noise < 0 ? -1 : options.noise * scale, job);
  report.noise_median = clean.median_level / scale;
  report.noise_highest = clean.highest_level / scale;
  report.moved_samples = clean.moved;
  if (clean.moved == 0) return {};
  Noise noise{std::vector<double>(cloud.positions.size(), 0), {}};
  noise.backing = noise.level;
  for (std::size_t k = 0; k < samples.source.size(); ++k) {
    noise.level[samples.source[k]] = clean.level[k];
    noise.backing[samples.source[k]] = clean.backing[k];
  }
  for (Vec3& p : clean.points) p = samples.frame.to_local(samples.frame.to_user(p));  // exact
  replace_points(clean.points, samples);
  return noise;
}

// Moves noisy samples onto the smooth pieces of the surface of `labels`. `noise` as of
// remove_noise.
void settle(const PointCloud& cloud, const Noise& noise, const Stage& stage, const Labels& labels,
            Samples& samples, Job& job) {
  job.stage("settle", 0);                               // not foreseen
  const std::vector<Vec3>& before = stage.mesh.points;  // background points stay where they are
  std::vector<Vec3> measured = before;
  std::vector<double> level(before.size(), 0), backing(before.size(), 0);
  for (std::size_t k = 0; k < samples.source.size(); ++k) {
    measured[k] = samples.frame.to_local(cloud.positions[samples.source[k]]);
    level[k] = noise.level[samples.source[k]];
    backing[k] = noise.backing[samples.source[k]];
  }
  const FacetMesh mesh(boundary_triangles(stage.mesh, labels), before, job.threads());
  std::vector<Vec3> points =
      settle_samples({before, measured, backing, level, stage.model.spacing}, mesh, job);
  points.resize(samples.points.size());
  for (Vec3& p : points) p = samples.frame.to_local(samples.frame.to_user(p));  // exact
  replace_points(points, samples);
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
// and the surface is cut anew, until there is nothing to add. The rounds between the first and the
// last surface go without swaps.
void sharpen(Stage& stage, const Samples& samples, double share, Labels& labels, Report& report,
             Job& job) {
  constexpr int rounds = 2;
  std::vector<FeaturePoint> features;
  for (int round = 1; round <= rounds; ++round) {
    job.stage("features " + std::to_string(round), share / rounds);
    Stage next = add_features(stage, labels, samples, features, job);
    if (next.mesh.points.empty()) break;
    stage = std::move(next);
    SurfaceCut cut = cut_manifold(stage, {}, report, job);
    report.cut_energy.push_back(cut.energy);
    labels = std::move(cut.labels);
  }
  report.feature_points = features.size();
}

void require_inside(const Labels& labels) {
  if (std::find(labels.begin(), labels.end(), std::uint8_t{1}) == labels.end())
    throw Failure(ErrorCode::no_surface, "the points do not enclose a volume: nothing is inside",
                  "scan the object from more sides, or give more points");
}

// Settles the samples on their surface and makes a new one, again where the noise is deep.
void settle_noise(const PointCloud& cloud, const Noise& noise, const Options& options,
                  Samples& samples, Stage& stage, Labels& labels, Report& report, Job& job) {
  const double level = report.noise_median * samples.frame.scale;
  std::vector<double> spacing = stage.model.spacing;
  const auto middle = spacing.begin() + static_cast<std::ptrdiff_t>(spacing.size() / 2);
  std::nth_element(spacing.begin(), middle, spacing.end());
  const int rounds = level < shallow_noise * *middle ? 0 : level > deep_noise * *middle ? 2 : 1;
  constexpr Shares shares = {};  // not foreseen
  for (int round = 0; round < rounds; ++round) {
    settle(cloud, noise, stage, labels, samples, job);
    stage = make_stage(samples, options, shares, report, job);
    labels = iterate_cuts(stage, options.cycles, shares.cut, report, job);
    require_inside(labels);
    job.stage("swap", shares.swap);
    if (options.swap) run_swaps(stage, labels, report, job);
  }
  stage.roughness = (rounds == 0 ? left_of_noise : left_when_settled) * level;
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
  const Shares& shares = options.background > 0 ? paper_shares : automatic_shares;

  job.stage("samples", shares.samples);
  Samples samples = prepare_samples(cloud.positions, options.non_finite, job);
  if (options.outliers == Outliers::drop) {
    job.stage("outliers", shares.outliers);
    report.stray_outliers = drop_samples(samples, find_outliers(samples.points, job));
  }
  Noise noise;
  if (options.noise != 0) noise = remove_noise(cloud, options, shares.noise, samples, report, job);
  Stage stage = make_stage(samples, options, shares, report, job);
  Labels labels = iterate_cuts(stage, options.cycles, shares.cut, report, job);
  for (int round = 0; options.outliers == Outliers::drop && round < most_spike_rounds; ++round) {
    const std::uint64_t dropped = drop_spikes(stage, labels, samples, job);
    if (dropped == 0) break;
    report.surface_outliers += dropped;
    constexpr Shares again = {};  // not foreseen
    stage = make_stage(samples, options, again, report, job);
    labels = iterate_cuts(stage, options.cycles, again.cut, report, job);
  }
  require_inside(labels);
  job.stage("swap", shares.swap);
  if (options.swap) run_swaps(stage, labels, report, job);
  if (!noise.level.empty())
    settle_noise(cloud, noise, options, samples, stage, labels, report, job);
  if (options.sharpen) {
    sharpen(stage, samples, shares.features, labels, report, job);
    job.stage("swap again", shares.swap);
    if (options.swap && report.feature_points > 0) run_swaps(stage, labels, report, job);
    stage.mesh.samples = samples.points.size();
  }

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
