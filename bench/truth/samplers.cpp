#include "truth/samplers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/vec.h"
#include "truth/eliminate.h"
#include "truth/measure.h"
#include "truth/random.h"
#include "truth/scanner.h"

namespace arris::truth {
namespace {

constexpr std::size_t candidates_per_sample = 5;  // Yuksel's choice
constexpr double grading = 10;                    // densest to thinnest

void require_area(double area) {
  if (!(area > 0 && std::isfinite(area)))
    throw std::invalid_argument("the area of the mesh is zero or out of range");
}

// Draws points uniformly by area.
class AreaSampler {
 public:
  explicit AreaSampler(const Mesh& mesh) : mesh_(mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      sums_.push_back(sum_ += length(normal(mesh, static_cast<Index>(t))));
    require_area(sum_);
  }

  void draw(Random& random, Samples& samples) const {
    const auto at = std::lower_bound(sums_.begin(), sums_.end() - 1, random.unit() * sum_);
    const auto triangle = static_cast<Index>(at - sums_.begin());
    const Triangle& t = mesh_.triangles[triangle];
    double u = random.unit(), v = random.unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3 a = mesh_.vertices[t[0]], n = normal(mesh_, triangle);
    samples.add(a + u * (mesh_.vertices[t[1]] - a) + v * (mesh_.vertices[t[2]] - a),
                (1 / length(n)) * n);
  }

 private:
  const Mesh& mesh_;
  std::vector<double> sums_;  // of the areas up to each triangle, doubled
  double sum_ = 0;
};

// Faces name vertices, and these are finite.
void require_sound(const Mesh& mesh) {
  for (const Triangle& t : mesh.triangles)
    for (const Index v : t)
      if (v >= mesh.vertices.size()) throw std::invalid_argument("a face names no vertex");
  for (const Vec3 p : mesh.vertices)
    if (!is_finite(p)) throw std::invalid_argument("a vertex is not finite");
}

Samples draw_uniform(const Mesh& mesh, std::size_t n, std::uint64_t seed) {
  const AreaSampler sampler(mesh);
  Random random(seed);
  Samples samples;
  while (samples.size() < n) sampler.draw(random, samples);
  return samples;
}

Samples chosen(const Samples& from, const std::vector<std::size_t>& indices) {
  Samples samples;
  for (const std::size_t i : indices) samples.add(from.positions[i], from.directions[i]);
  return samples;
}

// `samples` first, all of them, then blue noise between them.
Samples fill_with_blue(Samples samples, const Mesh& mesh, const Sampling& sampling) {
  const std::size_t n = sampling.samples, kept = samples.size();
  const Samples more = draw_uniform(mesh, candidates_per_sample * n, sampling.seed);
  for (std::size_t i = 0; i < more.size(); ++i) samples.add(more.positions[i], more.directions[i]);
  return chosen(samples, eliminate(samples.positions, {}, kept, n, ideal_spacing(area(mesh), n)));
}

Samples draw_graded(const Mesh& mesh, const Sampling& sampling) {
  Random random(sampling.seed);
  const Vec3 along = random.direction();
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Triangle& t : mesh.triangles)
    for (const Index v : t) {
      low = std::min(low, dot(along, mesh.vertices[v]));
      high = std::max(high, dot(along, mesh.vertices[v]));
    }
  // Density 1 at the dense end; uniform samples are kept with that probability.
  const AreaSampler sampler(mesh);
  Samples tried, kept;
  std::vector<double> scale;
  double density_sum = 0;
  while (kept.size() < candidates_per_sample * sampling.samples) {
    sampler.draw(random, tried);
    const double t = (dot(along, tried.positions.back()) - low) / (high - low);
    const double density = std::pow(grading, -t);
    density_sum += density;
    if (random.unit() > density) continue;
    kept.add(tried.positions.back(), tried.directions.back());
    scale.push_back(1 / std::sqrt(density));
  }
  const double mean_density = density_sum / static_cast<double>(tried.size());
  const double densest = ideal_spacing(area(mesh) * mean_density, sampling.samples);
  return chosen(kept, eliminate(kept.positions, scale, 0, sampling.samples, densest));
}

}  // namespace

double ideal_spacing(double area, std::size_t n) {
  return std::sqrt(2 * area / (std::sqrt(3.0) * static_cast<double>(n)));
}

std::size_t samples_at_spacing(double area, double spacing) {
  return static_cast<std::size_t>(std::ceil(2 * area / (std::sqrt(3.0) * spacing * spacing)));
}

Samples sample(const Mesh& mesh, const Sampling& sampling) {
  require_sound(mesh);
  switch (sampling.mode) {
    case Mode::uniform:
      return draw_uniform(mesh, sampling.samples, sampling.seed);
    case Mode::blue:
      return fill_with_blue({}, mesh, sampling);
    case Mode::feature: {
      const double all = area(mesh);
      require_area(all);
      const double spacing = ideal_spacing(all, sampling.samples);
      return fill_with_blue(feature_samples(mesh, spacing, sampling.edge_angle), mesh, sampling);
    }
    case Mode::graded:
      return draw_graded(mesh, sampling);
    case Mode::scan:
      return scan(mesh, sampling.samples, sampling.views, sampling.seed);
  }
  throw std::invalid_argument("unknown mode");
}

std::vector<Vec3> sample_uniform(const Mesh& mesh, std::size_t n, std::uint64_t seed) {
  return sample(mesh, {Mode::uniform, n, seed}).positions;
}

std::vector<Vec3> sample_blue(const Mesh& mesh, std::size_t n, std::uint64_t seed) {
  return sample(mesh, {Mode::blue, n, seed}).positions;
}

std::vector<Vec3> sample_feature(const Mesh& mesh, std::size_t n, std::uint64_t seed,
                                 double edge_angle) {
  return sample(mesh, {Mode::feature, n, seed, edge_angle}).positions;
}

}  // namespace arris::truth
