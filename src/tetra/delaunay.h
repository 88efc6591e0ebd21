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

// A mesh to which points were added, and per tetrahedron its number in the mesh before, or no_tet.
struct Extension {
  TetMesh mesh;
  std::vector<Tet> former;
};

// The Delaunay tetrahedralization of the points of `mesh`, which delaunay() gave, and of `added`,
// finite: as delaunay() of all of them, all samples, but for the order of tetrahedra that share
// their lowest vertex. An added point that lies exactly on another takes its place: the other is
// then a vertex of no tetrahedron. near[k]: a point of `mesh` beside added[k], from where its place
// is sought. Throws Failure(cancelled). Complexity: O(size of the mesh), with a small factor, and
// O(1) expected for each added point.
Extension add_points(const TetMesh& mesh, const std::vector<Vec3>& added,
                     const std::vector<Index>& near, Job& job);

}  // namespace arris
