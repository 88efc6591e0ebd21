// The largest patch round every sample that one smooth piece of surface explains.
//
// The patch grows from the nearest ten samples, by half its size at a time, while a plane or a
// quadric fits it up to noise of the known level: Lepski's choice of a scale (1991). It does so in
// each of eight sectors by itself, so that it fills a face up to its edges: the star-shaped
// neighbourhoods of Katkovnik, Foi, Egiazarian, Astola (From local kernel to nonlocal
// multiple-model image denoising, 2010). Samples next to a feature, where even the smallest patch
// is not smooth, are served by the patches of their neighbours on the same side (project.h).
#pragma once

#include <array>
#include <vector>

#include "arris/types.h"
#include "base/job.h"
#include "cloud/nearest.h"
#include "noise/height_fit.h"

namespace arris {

inline constexpr std::size_t sectors = 8;

// The sector of the patch, round its normal, that a point in its frame lies in.
std::size_t sector_of(Vec3 local) noexcept;

struct PatchFit {
  HeightFit fit;                        // terms = 0: nothing smooth fits even the smallest patch
  Index count = 0;                      // samples it was fitted to
  std::array<double, sectors> reach{};  // how far it extends in each sector

  bool covers(Vec3 local) const noexcept;  // a point in the frame of the fit
};

// A patch stands at every so manyth point (they are in order along a curve); patches overlap, so
// more say little more.
inline constexpr std::size_t patch_stride = 3;

// The patch round the origin of `frame`, which stands on the normal, among samples that are known
// to lie on one side of every feature: `local`, in the frame, nearest first. `level` > 0. Planes
// must be straight here. O(n log n).
PatchFit fit_patch(const std::vector<Vec3>& local, const Frame& frame, double level);

// The fits at every patch_stride-th point, from the first, whose level is positive; the others have
// none. Complexity: O(n log n); at most a few hundred samples a patch.
std::vector<PatchFit> fit_patches(const std::vector<Vec3>& points, const NearestSample& tree,
                                  const std::vector<double>& level, Job& job);

}  // namespace arris
