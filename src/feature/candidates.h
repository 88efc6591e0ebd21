// Candidates for feature points: where the surfaces on both sides of a crossing meet.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/job.h"
#include "feature/crossing.h"

namespace arris {

// A point where two (edge) or three (corner) smooth surfaces meet, on no sample.
struct FeaturePoint {
  Vec3 position;
  double spacing = 0;  // h there
  bool corner = false;
  Index near = no_index;    // one of the points it was found from
  Index vertex = no_index;  // the point it is, where it is one already
  std::vector<LocalSurface> surfaces;
  // Where planes were carried on to it across a gap of the samples: how wide that is, as a length,
  // and how they all turn at it (none: not all alike). Else 0 and none.
  double gap = 0;
  Turn turn = Turn::none;
};

struct Candidate {
  FeaturePoint point;
  double far;  // from the nearest (edge) or farthest (corner) point it was found from, over h
};

// The smallest and the largest of `share` of the spacings; infinity and 0 if there are none.
std::array<double, 2> radii(const std::vector<Candidate>& candidates, double share);

// On edges: for each of the crossing sides the points of the curve across its middle and nearest to
// its ends. O(sides).
std::vector<Candidate> edge_candidates(const Crossing& crossing,
                                       std::span<const CrossingSide> sides, Job& job);

// At corners: for each facet round which three distinct surfaces meet, which is near those sides or
// near samples on a feature. Those that most facets find come first. O(facets).
std::vector<Candidate> corner_candidates(const Crossing& crossing,
                                         std::span<const CrossingSide> sides, Job& job);

}  // namespace arris
