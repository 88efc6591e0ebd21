#include "support/samplers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "base/vec.h"
#include "support/measure.h"
#include "support/random.h"

namespace arris::test {
namespace {

constexpr std::size_t candidates_per_sample = 5;  // Yuksel's choice

// Points sorted into cubes of side `cell`, to find those within that distance.
class Grid {
 public:
  Grid(const std::vector<Vec3>& points, double cell) : points_(points), cell_(cell) {
    for (std::size_t i = 0; i < points.size(); ++i) entries_.push_back({key(points[i]), i});
    std::sort(entries_.begin(), entries_.end());
  }

  // visit(j, distance) for every other point j nearer than a cell.
  template <class Visit>
  void neighbours(std::size_t i, Visit visit) const {
    const Key centre = key(points_[i]);
    for (long x = -1; x <= 1; ++x)
      for (long y = -1; y <= 1; ++y) {
        // Cells that differ in z alone are consecutive.
        const Key first = {centre[0] + x, centre[1] + y, centre[2] - 1};
        const Key last = {first[0], first[1], centre[2] + 1};
        auto at = std::lower_bound(entries_.begin(), entries_.end(), Entry{first, 0});
        for (; at != entries_.end() && at->first <= last; ++at) {
          const double d = distance(points_[i], points_[at->second]);
          if (at->second != i && d < cell_) visit(at->second, d);
        }
      }
  }

 private:
  using Key = std::array<long, 3>;
  using Entry = std::pair<Key, std::size_t>;

  Key key(Vec3 p) const {
    return {std::lround(std::floor(p.x / cell_)), std::lround(std::floor(p.y / cell_)),
            std::lround(std::floor(p.z / cell_))};
  }

  const std::vector<Vec3>& points_;
  double cell_;
  std::vector<Entry> entries_;
};

// How much a neighbour at distance d crowds a point (Yuksel, eq. 2).
double crowding(double d, double spacing) {
  const double w = 1 - d / spacing, w2 = w * w, w4 = w2 * w2;
  return w4 * w4;
}

// Removes the most crowded points until n are left; the first `kept` are never removed.
std::vector<Vec3> eliminate(const std::vector<Vec3>& points, std::size_t kept, std::size_t n,
                            double spacing) {
  const Grid grid(points, spacing);
  std::vector<double> weight(points.size(), 0);
  std::priority_queue<std::pair<double, std::size_t>> queue;
  for (std::size_t i = kept; i < points.size(); ++i) {
    grid.neighbours(i, [&](std::size_t, double d) { weight[i] += crowding(d, spacing); });
    queue.push({weight[i], i});
  }
  std::vector<bool> removed(points.size());
  for (std::size_t left = points.size(); left > std::max(n, kept);) {
    const auto [w, i] = queue.top();
    queue.pop();
    if (w != weight[i]) {  // outdated: weights only fall, so each point needs one entry
      queue.push({weight[i], i});
      continue;
    }
    removed[i] = true;
    --left;
    grid.neighbours(i, [&](std::size_t j, double d) {
      if (j < kept || removed[j]) return;
      weight[j] -= crowding(d, spacing);
    });
  }
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!removed[i]) result.push_back(points[i]);
  return result;
}

}  // namespace

double ideal_spacing(double area, std::size_t n) {
  return std::sqrt(2 * area / (std::sqrt(3.0) * static_cast<double>(n)));
}

std::vector<Vec3> sample_uniform(const Mesh& mesh, std::size_t n, std::uint64_t seed) {
  std::vector<double> sums;  // of the areas up to each triangle, doubled
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sums.push_back(sum += length(normal(mesh, static_cast<Index>(t))));

  Random random(seed);
  std::vector<Vec3> points;
  points.reserve(n);
  while (points.size() < n) {
    const auto at = std::lower_bound(sums.begin(), sums.end() - 1, random.unit() * sum);
    const Triangle& t = mesh.triangles[static_cast<std::size_t>(at - sums.begin())];
    double u = random.unit(), v = random.unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3 a = mesh.vertices[t[0]];
    points.push_back(a + u * (mesh.vertices[t[1]] - a) + v * (mesh.vertices[t[2]] - a));
  }
  return points;
}

std::vector<Vec3> sample_blue(const Mesh& mesh, std::size_t n, std::uint64_t seed) {
  return eliminate(sample_uniform(mesh, candidates_per_sample * n, seed), 0, n,
                   ideal_spacing(area(mesh), n));
}

std::vector<Vec3> sample_feature(const Mesh& mesh, std::size_t n, std::uint64_t seed,
                                 double edge_angle) {
  const double spacing = ideal_spacing(area(mesh), n);
  std::vector<Vec3> points = feature_points(mesh, spacing, edge_angle);
  const std::size_t kept = points.size();
  const std::vector<Vec3> others = sample_uniform(mesh, candidates_per_sample * n, seed);
  points.insert(points.end(), others.begin(), others.end());
  return eliminate(points, kept, n, spacing);
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
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low = {infinity, infinity, infinity}, high = -low;
  for (const Vec3 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double pad = distance(low, high) / 10;
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    points.push_back({low.x - pad + x * (high.x - low.x + 2 * pad),
                      low.y - pad + y * (high.y - low.y + 2 * pad),
                      low.z - pad + z * (high.z - low.z + 2 * pad)});
  }
}

}  // namespace arris::test
