// Which side of each closed component is the solid, decided exactly.
#pragma once

#include <span>

#include "arris/types.h"
#include "base/job.h"
#include "surface/box_tree.h"
#include "surface/defects.h"
#include "surface/mesh_topology.h"

namespace arris {

// Counts the components whose normals point into the solid. A component inside an even number of
// others bounds solid from outside and must be walked counter-clockwise seen from outside; one
// inside an odd number bounds a cavity and must be walked the other way.
// The mesh must be a closed consistently walked manifold free of intersections and degenerate
// triangles, and `tree` must hold all its triangles. The example is {triangle of the component,
// 1 if it bounds a cavity}. Throws Failure(cancelled).
// Complexity: one ray a component through the tree, and the stars of one vertex a component.
Defects find_inward_components(std::span<const Vec3> points, std::span<const Triangle> triangles,
                               const MeshTopology& topology, const BoxTree& tree, Job& job);

}  // namespace arris
