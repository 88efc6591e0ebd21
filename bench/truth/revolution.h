// Surfaces of revolution about the z axis.
#pragma once

#include <vector>

#include "arris/types.h"

namespace arris::truth {

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

// The mesh turned about the z axis. Parts on one axis, or through each other's axes, combine better
// if they are turned by a part of a step: edges that nearly coincide would leave slivers.
Mesh turned_about_z(Mesh mesh, double angle);

}  // namespace arris::truth
