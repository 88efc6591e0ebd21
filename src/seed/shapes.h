// What the tetrahedra of a mesh look like to those who carry labels over to another mesh.
#pragma once

#include <array>

#include "tetra/geometry.h"
#include "tetra/stars.h"
#include "tetra/tet_mesh.h"

namespace arris {

Vec3 centroid(const TetMesh& mesh, Tet t);
double longest_edge(const TetMesh& mesh, Tet t);

// A tetrahedron flatter than a tenth of the spacing h and longer than a firm ball bridges coplanar
// faces: what holds its centroid is chance, and a stack of them on a wrong side outvotes the cut.
// `base`: its largest_base.
bool is_bridge(const TetMesh& mesh, Tet t, const TetBase& base, double h);

// The tetrahedron of `mesh` with these corners, or no_tet. O(degree).
Tet find_tet(const TetMesh& mesh, const Stars& stars, std::array<Index, 4> corners);

}  // namespace arris
