// From noisy samples to the surface that the patches round them agree on, features kept.
//
// A sample takes the patches of its neighbours that reach it and that it fits; next to an edge
// these are patches of its own side, whose middles lie away from the edge (the choice of Kuwahara's
// filter, 1976, among overlapping windows). Where patches of two or three orientations fit, it goes
// to whichever piece really extends to it, or to the edge or corner where they meet.
#pragma once

#include <functional>
#include <vector>

#include "arris/types.h"
#include "base/job.h"
#include "noise/adaptive_fit.h"

namespace arris {

struct Projection {
  std::vector<Vec3> points;     // bit-equal where not moved: no level, or no patch that fits
  std::vector<double> backing;  // samples that a new place is the mean of, as its variance has it
};

// Whether a patch, which has that normal at point i, may say where it goes.
using MayBear = std::function<bool(Index i, const PatchFit& patch, Vec3 normal)>;

// `fits`: of every patch_stride-th point, from the first. Without `may_bear` every patch may.
// Complexity: O(n log n).
Projection project_samples(const std::vector<Vec3>& points, const std::vector<double>& level,
                           const std::vector<PatchFit>& fits, Job& job,
                           const MayBear& may_bear = {});

}  // namespace arris
