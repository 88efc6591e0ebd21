// First surfaces of noisy samples: closed, bevelled at every edge, and rough.
#pragma once

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
