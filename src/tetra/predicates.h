// Exact geometric predicates on doubles. A floating-point filter decides nearly always; the rest is
// decided with exact arithmetic (CGAL, hidden in predicates.cpp). Coordinates must be finite.
#pragma once

#include "arris/types.h"

namespace arris {

// Sign of the volume of (a, b, c, d): +1 if d lies on the side of the plane abc to which
// (b-a) x (c-a) points, i.e. the tetrahedron is positively oriented; -1 on the other; 0 coplanar.
int orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

// Sign of the signed area of (a, b, c) projected along `axis` (0: onto yz, 1: onto zx, 2: onto xy);
// +1 if counter-clockwise seen from the positive end of that axis.
int orient2d(Vec3 a, Vec3 b, Vec3 c, int axis);

// The three points lie on one line (equal points count).
bool collinear(Vec3 a, Vec3 b, Vec3 c);

}  // namespace arris
