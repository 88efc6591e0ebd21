// The background points Q of the paper (section 3): not on the surface, they let the cut pass
// between samples and carry the signed distance.
#pragma once

#include <vector>

#include "cloud/prepare.h"
#include "tetra/tet_mesh.h"

namespace arris {

struct Background {
  std::vector<Vec3> points;    // local frame
  std::vector<Index> nearest;  // sample nearest to each
};

// A jittered body-centred lattice over the padded box of the samples, `per_sample` points a sample
// before those nearer than `clearance` spacings to a sample are left out. The jitter is a hash of
// the lattice cell: same input, same points. Every point is exact in the user's frame too, and
// all are distinct.
// Complexity: O(m log n) for m points.
Background background_points(const std::vector<Vec3>& samples, const std::vector<double>& spacing,
                             const LocalFrame& frame, double per_sample, Job& job);

// The TetMesh::nearest of samples followed by these background points.
std::vector<Index> nearest_samples(std::size_t samples, const Background& background);

}  // namespace arris
