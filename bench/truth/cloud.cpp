#include "truth/cloud.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/vec.h"
#include "truth/measure.h"
#include "truth/random.h"

namespace arris::truth {
namespace {

// Random numbers of one step: those of different steps have nothing to do with each other.
enum class Step : std::uint64_t { patches = 1, noise, outliers, order };

std::uint64_t seed_of(std::uint64_t seed, Step step) {
  Random random(seed);
  std::uint64_t result = 0;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(step); ++i) result = random.next();
  return result;
}

// Volatile, since GCC 12 drops the way to float and back where it takes two coordinates at once
// (-ftree-slp-vectorize).
double as_float(double x) {
  const volatile float narrow = static_cast<float>(x);
  return static_cast<double>(narrow);
}

// Centres far apart from those before, as far as a bounded number of draws finds them.
std::vector<Vec3> patch_centres(const Samples& samples, int count, double apart, Random& random) {
  constexpr int draws = 1000;
  std::vector<Vec3> centres;
  for (int i = 0; i < count; ++i) {
    Vec3 candidate;
    for (int draw = 0; draw < draws; ++draw) {
      candidate = samples.positions[random.below(samples.size())];
      if (std::all_of(centres.begin(), centres.end(),
                      [&](Vec3 c) { return distance(c, candidate) >= apart; }))
        break;
    }
    centres.push_back(candidate);
  }
  return centres;
}

void shuffle(std::vector<Vec3>& points, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
}

}  // namespace

void remove_patches(Samples& samples, int count, double radius, std::uint64_t seed) {
  if (samples.size() == 0) return;
  Random random(seed);
  const std::vector<Vec3> centres = patch_centres(samples, count, 3 * radius, random);
  Samples left;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3 p = samples.positions[i];
    if (std::all_of(centres.begin(), centres.end(),
                    [&](Vec3 c) { return distance(c, p) >= radius; }))
      left.add(p, samples.directions[i]);
  }
  samples = std::move(left);
}

void add_noise(Samples& samples, double sigma, NoiseDirection direction, std::uint64_t seed) {
  if (direction == NoiseDirection::isotropic) return add_noise(samples.positions, sigma, seed);
  Random random(seed);
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples.positions[i] = samples.positions[i] + (sigma * random.normal()) * samples.directions[i];
}

void add_noise(std::vector<Vec3>& points, double sigma, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& p : points) {
    p.x += sigma * random.normal();
    p.y += sigma * random.normal();
    p.z += sigma * random.normal();
  }
}

void add_outliers(std::vector<Vec3>& points, std::size_t count, std::uint64_t seed) {
  if (points.empty()) return;
  const auto [low, high] = bounds_of(points);
  const double pad = distance(low, high) / 10;
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    points.push_back({low.x - pad + x * (high.x - low.x + 2 * pad),
                      low.y - pad + y * (high.y - low.y + 2 * pad),
                      low.z - pad + z * (high.z - low.z + 2 * pad)});
  }
}

Cloud make_cloud(const Mesh& mesh, const CloudOptions& options) {
  const Sampling& sampling = options.sampling;
  const auto seed = [&](Step step) { return seed_of(sampling.seed, step); };
  Samples samples = sample(mesh, sampling);
  Cloud cloud;
  cloud.spacing = ideal_spacing(area(mesh), sampling.samples);
  const double diagonal = bounds_of(mesh.vertices).diagonal();
  if (options.missing > 0) {
    cloud.missing = samples.size();
    remove_patches(samples, options.missing, options.missing_radius * diagonal,
                   seed(Step::patches));
    cloud.missing -= samples.size();
  }
  if (samples.size() == 0) throw std::invalid_argument("the missing patches leave no samples");
  if (options.noise > 0) {
    const double unit = options.noise_in_spacings ? cloud.spacing : diagonal;
    add_noise(samples, options.noise * unit, options.noise_direction, seed(Step::noise));
  }
  const double outliers = options.outliers * static_cast<double>(samples.size());
  cloud.outliers = static_cast<std::size_t>(std::llround(outliers));
  add_outliers(samples.positions, cloud.outliers, seed(Step::outliers));
  shuffle(samples.positions, seed(Step::order));
  cloud.points.positions = std::move(samples.positions);
  cloud.points.position_type = ScalarType::f32;
  for (Vec3& p : cloud.points.positions) p = {as_float(p.x), as_float(p.y), as_float(p.z)};
  return cloud;
}

}  // namespace arris::truth
