// Where sensed surfaces meet: Newton's method on two or three of them.
#pragma once

#include <optional>

#include "feature/local_surface.h"

namespace arris {

// The point of the curve in which a and b meet, in the plane through `start` across it. None where
// the sine of the angle between them falls below `least_sine`, or where the steps do not converge.
std::optional<Vec3> meet(const LocalSurface& a, const LocalSurface& b, Vec3 start,
                         double least_sine);

// The point that three surfaces share, near `start`. None where they have a common direction, or
// where the steps do not converge.
std::optional<Vec3> meet(const LocalSurface& a, const LocalSurface& b, const LocalSurface& c,
                         Vec3 start);

}  // namespace arris
