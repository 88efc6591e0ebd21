#include "tetra/background.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/vec.h"
#include "cloud/nearest.h"

namespace arris {
namespace {

// Nearer than this many spacings a background point would break up the triangles between samples. A
// triangle stays Delaunay if the ball round its circumcircle is empty; a point of that ball is
// within sqrt(2) circumradii of a corner, and those of a sampled surface reach about 0.9 spacings.
// At 0.9 instead of 1.3, ten background points came to lie on the surface of two_cubes, none
// at 1.3.
constexpr double clearance = 1.3;
// Half the jitter, as a share of the lattice constant: enough to break cospherical cells (there is
// no tie left to perturb), little enough to keep the points well apart.
constexpr double jitter = 0.2;
// Lattice cells beyond the box of the samples, so that the hull is made of background points.
constexpr double padding_cells = 2;

// splitmix64 (Steele, Lea, Flood 2014): a hash good enough to look random.
std::uint64_t hash(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

struct Lattice {
  Vec3 origin;
  double cell = 0;  // lattice constant: two points a cube
  std::array<std::uint64_t, 3> cells{};

  std::uint64_t size() const { return 2 * cells[0] * cells[1] * cells[2]; }
  Vec3 point(std::uint64_t k) const {
    const std::uint64_t cube = k / 2;
    const double half = k % 2 == 0 ? 0.0 : 0.5;
    const auto shake = [&](std::uint64_t axis) {
      return jitter * (static_cast<double>(hash(3 * k + axis) >> 11) * 0x1p-52 - 1);
    };
    const auto along = [&](std::uint64_t index, std::uint64_t axis) {
      return cell * (static_cast<double>(index) + half + shake(axis));
    };
    return origin + Vec3{along(cube % cells[0], 0), along(cube / cells[0] % cells[1], 1),
                         along(cube / cells[0] / cells[1], 2)};
  }
};

Lattice choose_lattice(const std::vector<Vec3>& samples, double per_sample) {
  Vec3 low = samples[0], high = low;
  for (Vec3 p : samples) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3 size = high - low;
  const double wanted = per_sample * static_cast<double>(samples.size());
  // The padding depends on the cell and the cell on the padded volume: a few rounds settle it.
  Lattice lattice;
  lattice.cell = std::cbrt(2 * size.x * size.y * size.z / wanted);
  const double longest = std::max({size.x, size.y, size.z});
  lattice.cell = std::max(lattice.cell, longest / std::cbrt(wanted) / 4);
  for (int round = 0; round < 8; ++round) {
    const double pad = 2 * padding_cells * lattice.cell;
    lattice.cell = std::cbrt(2 * (size.x + pad) * (size.y + pad) * (size.z + pad) / wanted);
  }
  const double pad = padding_cells * lattice.cell;
  lattice.origin = low - Vec3{pad, pad, pad};
  const auto count = [&](double extent) {
    return static_cast<std::uint64_t>(std::ceil((extent + 2 * pad) / lattice.cell)) + 1;
  };
  lattice.cells = {count(size.x), count(size.y), count(size.z)};
  return lattice;
}

// Rounding to the user's frame moves lattice points by up to half a step of it, and the jitter
// leaves them at least 0.17 lattice constants apart: with this many steps to a constant, no two
// fall together.
constexpr double steps_apart = 16;

// The distance of neighbouring doubles in the user's frame where it is largest, in the local one.
double coarsest_step(const Lattice& lattice, const LocalFrame& frame) {
  const auto reach = [&](Vec3 local) {
    const Vec3 p = frame.to_user(local);
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  };
  const auto along = [&](std::size_t axis) {
    return lattice.cell * static_cast<double>(lattice.cells[axis] + 1);
  };
  const Vec3 end = lattice.origin + Vec3{along(0), along(1), along(2)};
  return std::max(reach(lattice.origin), reach(end)) * 0x1p-52 * frame.scale;
}

// Keeps the first of equal points.
void drop_repeats(Background& background) {
  const std::vector<Vec3>& points = background.points;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return lexicographic_less(points[a], points[b]);
  });
  order.erase(std::unique(order.begin(), order.end(),
                          [&](std::size_t a, std::size_t b) { return points[a] == points[b]; }),
              order.end());
  std::sort(order.begin(), order.end());
  Background kept;
  for (std::size_t k : order) {
    kept.points.push_back(points[k]);
    kept.nearest.push_back(background.nearest[k]);
  }
  background = std::move(kept);
}

}  // namespace

Background background_points(const std::vector<Vec3>& samples, const std::vector<double>& spacing,
                             const LocalFrame& frame, double per_sample, Job& job) {
  Background background;
  if (!(per_sample > 0)) return background;
  const NearestSample nearest(samples);
  const Lattice lattice = choose_lattice(samples, per_sample);
  for (std::uint64_t k = 0; k < lattice.size(); ++k) {
    if (k % 4096 == 0) job.tick(static_cast<double>(k) / static_cast<double>(lattice.size()));
    const Vec3 p = frame.to_local(frame.to_user(lattice.point(k)));  // exact from here on
    const NearestSample::Hit hit = nearest(p);
    if (hit.distance < clearance * spacing[hit.index]) continue;
    background.points.push_back(p);
    background.nearest.push_back(hit.index);
  }
  if (lattice.cell < steps_apart * coarsest_step(lattice, frame)) drop_repeats(background);
  return background;
}

std::vector<Index> nearest_samples(std::size_t samples, const Background& background) {
  std::vector<Index> nearest(samples);
  std::iota(nearest.begin(), nearest.end(), Index{0});
  nearest.insert(nearest.end(), background.nearest.begin(), background.nearest.end());
  return nearest;
}

}  // namespace arris
