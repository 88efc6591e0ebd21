// From what the user brought to distinct finite samples in a well-conditioned local frame.
#pragma once

#include <cstdint>
#include <vector>

#include "arris/options.h"
#include "arris/types.h"
#include "base/job.h"

namespace arris {

// local = (user - shift) * scale, coordinate by coordinate. scale is a power of two. shift is 0 on
// an axis unless the points lie within a factor of two of it (Sterbenz's lemma: the subtraction is
// then exact), so for any cloud whose extent fits a double's exponent range the map has no rounding
// and Delaunay, orientation and intersection are the same in both frames.
struct LocalFrame {
  Vec3 shift;
  double scale = 1;

  Vec3 to_local(Vec3 user) const noexcept {
    return {(user.x - shift.x) * scale, (user.y - shift.y) * scale, (user.z - shift.z) * scale};
  }
  Vec3 to_user(Vec3 local) const noexcept {
    return {local.x / scale + shift.x, local.y / scale + shift.y, local.z / scale + shift.z};
  }
};

struct Samples {
  std::vector<Vec3> points;   // local frame, distinct, in canonical order (a Morton curve)
  std::vector<Index> source;  // input index of each; the first among duplicates
  LocalFrame frame;
  std::uint64_t non_finite = 0;  // dropped
  std::uint64_t duplicates = 0;  // merged
};

// Throws Failure: bad_points (non-finite under NonFinite::refuse, with the first index; none left),
// degenerate (fewer than four distinct points).
// Complexity: O(n log n). The result depends on the set of points, not on their order, except
// `source` among duplicates.
Samples prepare_samples(const std::vector<Vec3>& positions, NonFinite policy, Job& job);

// Gives every sample a new place (local frame); of several that come to the same place the first
// stays and the others count as duplicates. O(n log n).
void replace_points(const std::vector<Vec3>& points, Samples& samples);

}  // namespace arris
