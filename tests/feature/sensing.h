// First surfaces of blue samples, as sensing gets them: closed, bevelled at every edge.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "arris/reconstruct.h"
#include "feature/sense.h"
#include "support/job.h"
#include "support/samplers.h"
#include "support/shapes.h"
#include "support/tetra.h"

namespace arris::test {

inline Options unsharpened() {
  Options options;
  options.sharpen = false;
  return options;
}

inline Mesh bevelled_mesh(const Shape& shape, std::size_t n, std::uint64_t seed) {
  PointCloud cloud;
  cloud.positions = sample_blue(shape.mesh, n, seed);
  Result<Reconstruction> r = reconstruct(cloud, unsharpened());
  EXPECT_TRUE(r) << (r ? "" : r.error().message);
  return r ? std::move(r->mesh) : Mesh{};
}

// A surface with what is sensed of it; all its points are samples.
struct FirstSurface {
  std::vector<Vec3> points;
  FacetMesh facets;
  std::vector<double> spacing;
  Sensed sensed;

  explicit FirstSurface(const Shape& shape, std::size_t n, unsigned threads = 1,
                        std::uint64_t seed = 1)
      : FirstSurface(bevelled_mesh(shape, n, seed), threads) {}

  FirstSurface(const Mesh& mesh, unsigned threads)
      : points(mesh.vertices),
        facets(mesh.triangles, points, threads),
        spacing(Measured(points).spacing) {
    OneStageJob job(threads);
    sensed = sense_surfaces(points, facets, spacing, near_bends(facets, points.size()), {}, 0, job);
  }
};

}  // namespace arris::test
