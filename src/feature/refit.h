// Moves noisy samples onto planes and quadrics fitted to where they were measured, as far as the
// smooth pieces of a surface of them reach.
//
// Where the edges are known, patches (noise/adaptive_fit.h) need not find them by the residuals,
// which tell an edge only some way beyond it: they grow over the surface, among samples of one
// piece (pieces.h). So no fit bends round an edge, and on a flat face it grows to hundreds of
// samples. Settling (settle.h) needs no such surface, but means over a fixed width are less certain
// and lean towards edges.
#pragma once

#include <vector>

#include "base/job.h"
#include "feature/facets.h"
#include "feature/settle.h"

namespace arris {

// New places for the points of `mesh`, landed on their patches as in noise/project.h, or on the
// edge or corner where these meet. Points with a level of 0 stay, and have no say; so do those that
// no patch reaches. `backing` is not used. O(n) patches of at most some hundred samples, in
// parallel; the same for any number of threads. Throws Failure(cancelled).
std::vector<Vec3> refit_samples(const NoisySamples& samples, const FacetMesh& mesh, Job& job);

}  // namespace arris
