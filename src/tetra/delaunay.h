// Delaunay tetrahedralization. The engine (CGAL) is hidden in delaunay.cpp.
#pragma once

#include <vector>

#include "arris/types.h"
#include "base/job.h"
#include "tetra/tet_mesh.h"

namespace arris {

// Delaunay tetrahedralization of `points`, which must be finite and distinct; the first `samples`
// of them are samples. Ties between cospherical points are broken by the engine's symbolic
// perturbation, which depends on coordinates only, so the result depends on the set of points and
// not on their order. Vertices keep the order of `points`; tetrahedra are numbered along it.
// Throws Failure: degenerate (fewer than 4 points, or all coplanar), cancelled.
// Complexity: O(n log n) expected for points near a surface.
TetMesh delaunay(std::vector<Vec3> points, std::size_t samples, Job& job);

}  // namespace arris
