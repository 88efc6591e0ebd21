// Point location by walking.
#pragma once

#include "tetra/tet_mesh.h"

namespace arris {

// A tetrahedron that holds p (on its boundary counts), or an infinite one if p is outside the hull.
// Walks from `hint`, exact; visibility walks on Delaunay meshes do not cycle. O(distance).
Tet locate(const TetMesh& mesh, Vec3 p, Tet hint);

}  // namespace arris
