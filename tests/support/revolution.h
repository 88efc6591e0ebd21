// Surfaces of revolution about the z axis.
#pragma once

#include <vector>

#include "arris/types.h"

namespace arris::test {

// A point of a profile in the half plane: distance from the axis and height.
struct ProfilePoint {
  double radius, height;
};

// The arc of the circle (centre, r) from angle `from` to `to`, as `segments` chords.
std::vector<ProfilePoint> arc(double centre_radius, double centre_height, double r, double from,
                              double to, int segments);

// Revolves a profile whose two ends lie on the axis (radius 0), the lower one first, in `around`
// steps. The ends become one vertex each.
Mesh revolve(const std::vector<ProfilePoint>& profile, int around);

// Revolves a closed, counter-clockwise profile that does not touch the axis; the last point, equal
// to the first, is left out.
Mesh revolve_loop(const std::vector<ProfilePoint>& profile, int around);

}  // namespace arris::test
