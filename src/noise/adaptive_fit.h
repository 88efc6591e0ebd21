// The largest patch round every sample that one smooth piece of surface explains.
//
// The patch grows from the nearest ten samples by half its size at a time while a plane or a
// quadric fits it up to noise of the known level: Lepski's choice of a scale (1991), as Katkovnik
// et al. use it for images (From local kernel to nonlocal multiple-model image denoising, 2010).
// The patch stops short of a feature since no smooth piece fits across it; samples next to a
// feature are served by the patches of their neighbours on the same side (project.h).
#pragma once

#include <vector>

#include "arris/types.h"
#include "base/job.h"
#include "cloud/nearest.h"
#include "noise/height_fit.h"

namespace arris {

struct PatchFit {
  HeightFit fit;    // terms = 0: nothing smooth fits even the smallest patch
  Index count = 0;  // samples it was fitted to

  // The variance of the fitted height at tangential distance `reach` radii from the middle, in
  // units of the variance of the noise: that of Zernike's polynomials on a full disc.
  double variance(double reach) const noexcept;
};

// One fit per point whose level is positive; the others have none. Complexity: O(n log n); at most
// a few hundred samples a patch.
std::vector<PatchFit> fit_patches(const std::vector<Vec3>& points, const NearestSample& tree,
                                  const std::vector<double>& level, Job& job);

// Samples to gather round a point for a patch: enough that their mean is a hundredth of the
// spacing exact, within bounds.
std::size_t patch_limit(double level, double spacing) noexcept;

}  // namespace arris
