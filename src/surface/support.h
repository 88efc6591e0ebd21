// Which faces rest on samples, and which only close a gap between them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arris/types.h"
#include "base/job.h"

namespace arris {

// A surface over the samples that it was made from, all in one frame.
struct SampledSurface {
  std::span<const Vec3> vertices;
  std::span<const Triangle> triangles;
  const std::vector<Vec3>& samples;    // not empty
  const std::vector<double>& spacing;  // of the samples round each sample, > 0
};

// Per face the gap it spans: the largest distance of one of its points to the nearest sample, in
// units of the local spacing (the largest at its corners and at the samples nearest to it). Faces
// are looked at in steps of half a spacing, large ones more coarsely; gaps below 1 are not told
// apart and may come out as any number up to 1. And that spacing at the corners.
struct FaceGaps {
  std::vector<float> gap;
  std::vector<double> spacing;
};
// O(n log n), parallel.
FaceGaps face_gaps(const SampledSurface& surface, Job& job);

}  // namespace arris
