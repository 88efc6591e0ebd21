// Delaunay meshes as the rooms after tetra get them.
#pragma once

#include <utility>
#include <vector>

#include "support/job.h"
#include "tetra/delaunay.h"
#include "tetra/geometry.h"

namespace arris::test {

inline TetMesh delaunay_of(std::vector<Vec3> points) {
  OneStageJob job;
  const std::size_t samples = points.size();
  return delaunay(std::move(points), samples, job);
}

// A mesh of samples alone, with all that is measured on it.
struct Measured {
  TetMesh mesh;
  Stars stars;
  std::vector<double> spacing;
  std::vector<Circumball> balls;

  explicit Measured(std::vector<Vec3> points)
      : mesh(delaunay_of(std::move(points))),
        stars(mesh),
        spacing(sample_spacing(mesh, stars, 1)),
        balls(circumballs(mesh, 1)) {}
};

}  // namespace arris::test
