// How near parts of a surface come to each other that are not joined nearby.
#pragma once

#include "arris/types.h"

namespace arris::truth {

// The least distance, in the unit of the mesh, of a point p of the surface to a triangle that is
// joined to p inside no ball round p of three times that distance: the two sides of a wall or of a
// gap, a blade or a crevice whose sides meet at less than 19 degrees (then it is nearly 0), but
// neither a blunter edge nor a thin bar. Infinity if nothing comes nearer than `reach`. The points
// tried are the corners, points of sharp edges every `step`, and 1500 uniform on the surface. The
// mesh must be closed and manifold. O(points * triangles within three times the reach, at most).
double measure_clearance(const Mesh& mesh, double reach, double step);

}  // namespace arris::truth
