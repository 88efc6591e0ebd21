#include "surface/support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/parallel.h"
#include "base/vec.h"
#include "cloud/nearest.h"

namespace arris {
namespace {

// Steps along a side of a face, in spacings, and their largest number: 91 points.
constexpr double step = 0.5;
constexpr int most_steps = 12;
constexpr std::size_t most_places = (most_steps + 1) * (most_steps + 2) / 2;

class GapFinder {
 public:
  explicit GapFinder(const SampledSurface& surface)
      : surface_(surface),
        nearest_(surface.samples),
        spacing_(surface.vertices.size()),
        distance_(surface.vertices.size()) {}

  // Spacing of and distance to the nearest sample, per vertex.
  void measure_vertices(unsigned threads) {
    parallel_for(spacing_.size(), threads, [&](std::size_t v) {
      const auto hit = nearest_(surface_.vertices[v]);
      spacing_[v] = surface_.spacing[hit.index];
      distance_[v] = hit.distance;
    });
  }

  double spacing(std::size_t t) const {
    const Triangle& c = surface_.triangles[t];
    return std::max({spacing_[c[0]], spacing_[c[1]], spacing_[c[2]]});
  }

  double gap(std::size_t t) const {
    const Triangle& c = surface_.triangles[t];
    const std::array<Vec3, 3> x = {surface_.vertices[c[0]], surface_.vertices[c[1]],
                                   surface_.vertices[c[2]]};
    const double spacing = this->spacing(t);
    const double longest =
        std::max({distance(x[0], x[1]), distance(x[1], x[2]), distance(x[2], x[0])});
    // No point of a triangle is farther from its nearest corner than this.
    const double bound = longest / std::numbers::sqrt3 +
                         std::max({distance_[c[0]], distance_[c[1]], distance_[c[2]]});
    if (bound <= spacing) return bound / spacing;
    const int steps = static_cast<int>(
        std::clamp(std::ceil(longest / (step * spacing)), 3.0, static_cast<double>(most_steps)));
    const Vec3 u = 1.0 / steps * (x[1] - x[0]), v = 1.0 / steps * (x[2] - x[0]);
    std::array<std::pair<double, Vec3>, most_places> places;
    std::size_t count = 0;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const Vec3 p = x[0] + i * u + j * v;
        places[count++] = {within(p, c, x), p};
      }
    // Where the corners are far first: few of the others can be farther from a sample.
    const auto end = places.begin() + static_cast<std::ptrdiff_t>(count);
    std::sort(places.begin(), end, [](const auto& a, const auto& b) { return a.first > b.first; });
    double largest = 0;
    for (auto place = places.begin(); place != end && place->first > largest * spacing; ++place) {
      const auto hit = nearest_(place->second);
      largest = std::max(largest, hit.distance / std::max(spacing, surface_.spacing[hit.index]));
    }
    return largest;
  }

 private:
  // Some sample is no farther from p than this, a little more than by way of a corner.
  double within(Vec3 p, const Triangle& c, const std::array<Vec3, 3>& x) const {
    constexpr double rounding = 1 + 1e-12;
    return rounding *
           std::min({distance(p, x[0]) + distance_[c[0]], distance(p, x[1]) + distance_[c[1]],
                     distance(p, x[2]) + distance_[c[2]]});
  }

  const SampledSurface& surface_;
  NearestSample nearest_;
  std::vector<double> spacing_, distance_;
};

}  // namespace

FaceGaps face_gaps(const SampledSurface& surface, Job& job) {
  GapFinder finder(surface);
  job.tick(0.2);
  finder.measure_vertices(job.threads());
  job.tick(0.4);
  const std::size_t n = surface.triangles.size();
  FaceGaps result{std::vector<float>(n), std::vector<double>(n)};
  parallel_for(n, job.threads(), [&](std::size_t t) {
    if (job.cancelled()) return;  // the next tick throws
    result.gap[t] = static_cast<float>(finder.gap(t));
    result.spacing[t] = finder.spacing(t);
  });
  job.tick(1);
  return result;
}

}  // namespace arris
