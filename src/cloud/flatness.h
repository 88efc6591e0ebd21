// How flat a few points lie: the principal axes of their distribution.
#pragma once

#include <span>

#include "arris/types.h"

namespace arris {

struct Flatness {
  Vec3 normal;        // unit; direction of least variance, of either sign
  double least = 0;   // variance along the normal, >= 0
  double middle = 0;  // variance along the axis of middling variance
};

// Of at least one point. If the points are equal or in line, normal is any one across.
Flatness flatness(std::span<const Vec3> points);

}  // namespace arris
