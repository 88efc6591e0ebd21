// Moves noisy samples onto the smooth pieces of a first surface of them.
//
// A surface shows what a cloud does not: which samples are on one sheet, and on one side of an
// edge. Its filtered normals (normal_filter.h) say which piece a sample is on; it goes along the
// normal of that piece to where the samples of the piece near it were measured, on average, and so
// does not leave a face when its neighbours beyond an edge would draw it off.
#pragma once

#include <vector>

#include "base/job.h"
#include "feature/facets.h"

namespace arris {

struct NoisySamples {
  const std::vector<Vec3>& points;     // where the mesh has them
  const std::vector<Vec3>& measured;   // where the input has them
  const std::vector<double>& backing;  // samples that the place the mesh has each at is the mean of
  const std::vector<double>& level;    // standard deviation of their noise, a length
  const std::vector<double>& spacing;  // h > 0
};

// New places for the points of `mesh`. Those with a level of 0, and those not on the mesh, stay.
// O(points + facets) for bounded degrees, in parallel; the same for any number of threads. Throws
// Failure(cancelled).
std::vector<Vec3> settle_samples(const NoisySamples& samples, const FacetMesh& mesh, Job& job);

}  // namespace arris
