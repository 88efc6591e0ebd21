// Whether the topology lets a round of features stand, and which of its points to take back if not.
#pragma once

#include <span>
#include <vector>

#include "arris/types.h"
#include "feature/candidates.h"

namespace arris {

// A round of features before it is accepted. The last points are its `features`; `spacing` is h per
// point; `before` and `after` are the surfaces, closed 2-manifolds.
struct FeatureTrial {
  const std::vector<Vec3>& points;
  const std::vector<double>& spacing;
  std::vector<Triangle> before, after;
  std::span<const FeaturePoint> features;

  std::size_t first() const noexcept { return points.size() - features.size(); }
};

struct RefusedFeatures {
  std::vector<FeaturePoint> across;  // gaps: none is added within their width
  std::vector<Vec3> at_handles;      // these are not added; in lexicographic order
  int attempts = 0;                  // at handles
};

// What it takes to keep a round from making the topology worse: adds features to `refused` and
// returns true if the round should be done again without them, false if it stands.
//
// If the surface has another Euler characteristic than before, features across gaps are refused
// that are off it or that it does not follow the planes at; all of them if there is none such, or
// if some have been refused before. Then those where it got a handle, near sides that join what lay
// far apart, each time twice as far from these; a handle that is left after a few times stands, for
// mend_handles. A round can remove handles, and join or part components. O(points + triangles).
bool refuse_features(const FeatureTrial& trial, RefusedFeatures& refused);

}  // namespace arris
