#include "noise_stage.h"

#include "base/vec.h"
#include "feature/facets.h"
#include "feature/refit.h"
#include "feature/settle.h"
#include "noise/denoise.h"
#include "surface/extract.h"

namespace arris {

Noise remove_noise(const PointCloud& cloud, const Options& options, Samples& samples,
                   Report& report, Job& job) {
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

void settle(const PointCloud& cloud, const Noise& noise, const Stage& stage, const Labels& labels,
            Settling how, Samples& samples, Job& job) {
  const std::vector<Vec3>& before = stage.mesh.points;  // no others than the samples move
  std::vector<Vec3> measured = before;
  std::vector<double> level(before.size(), 0), backing(before.size(), 0);
  for (std::size_t k = 0; k < samples.source.size(); ++k) {
    measured[k] = samples.frame.to_local(cloud.positions[samples.source[k]]);
    level[k] = noise.level[samples.source[k]];
    backing[k] = noise.backing[samples.source[k]];
  }
  const FacetMesh mesh(boundary_triangles(stage.mesh, labels), before, job.threads());
  const NoisySamples noisy{before, measured, backing, level, stage.model.spacing};
  std::vector<Vec3> points =
      how == Settling::means ? settle_samples(noisy, mesh, job) : refit_samples(noisy, mesh, job);
  points.resize(samples.points.size());
  for (Vec3& p : points) p = samples.frame.to_local(samples.frame.to_user(p));  // exact
  replace_points(points, samples);
}

}  // namespace arris
