// First surfaces of noisy samples: closed, bevelled at every edge, and rough.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/vec.h"
#include "feature/refit.h"
#include "feature/sensing.h"
#include "feature/settle.h"

namespace arris::test {

// Blue samples of a shape, the surface of which every one was then moved by Gaussian noise of
// `noise` spacings on each axis.
struct RoughSurface {
  Mesh clean;
  std::vector<double> spacing;
  double h, sigma;
  std::vector<Vec3> points;
  std::vector<double> level, backing;  // backing: none, the points are where they were measured
  FacetMesh facets;

  RoughSurface(const Shape& shape, std::size_t n, double noise)
      : clean(bevelled_mesh(shape, n, 1)),
        spacing(Measured(clean.vertices).spacing),
        h(spacing[spacing.size() / 2]),
        sigma(noise * h),
        points(noisy(clean.vertices, sigma)),
        level(points.size(), sigma),
        backing(points.size(), 0),
        facets(clean.triangles, points, 1) {}

  std::vector<Vec3> settled(unsigned threads = 1) const {
    OneStageJob job(threads);
    return settle_samples({points, points, backing, level, spacing}, facets, job);
  }

  std::vector<Vec3> refitted(unsigned threads = 1) const {
    OneStageJob job(threads);
    return refit_samples({points, points, backing, level, spacing}, facets, job);
  }

  // How many points of a plate, off its rim, are on the side of the other sheet in z.
  std::size_t crossed(const std::vector<Vec3>& now) const {
    double low = 1e9, high = -1e9;
    for (Vec3 p : clean.vertices) low = std::min(low, p.z), high = std::max(high, p.z);
    const double middle = (low + high) / 2;
    std::size_t count = 0;
    for (std::size_t v = 0; v < now.size(); ++v) {
      const double side = clean.vertices[v].z - middle;
      if (std::abs(side) < 0.4 * (high - low)) continue;  // on the rim
      count += side * (now[v].z - middle) < 0 ? 1 : 0;
    }
    return count;
  }

  Vec3 middle(std::size_t facet) const {
    const Triangle& t = clean.triangles[facet];
    return 1.0 / 3 * (clean.vertices[t[0]] + clean.vertices[t[1]] + clean.vertices[t[2]]);
  }

 private:
  static std::vector<Vec3> noisy(std::vector<Vec3> points, double sigma) {
    add_noise(points, sigma, 2);
    return points;
  }
};

}  // namespace arris::test
