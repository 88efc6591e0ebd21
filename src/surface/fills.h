// Which faces to call filled, as regions with a clean boundary; and the mesh without them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arris/types.h"
#include "surface/mesh_topology.h"
#include "surface/support.h"

namespace arris {

// Faces whose flag is 1 close a gap in the samples. Regions grow from faces with a large gap over
// neighbours with a moderate one; small ones do not count. Then faces are added until what is left
// is a 2-manifold with boundary without small islands, faces that hang by a short edge, or vertices
// where two parts touch. The surface must be a closed 2-manifold with this topology. O(n) a round,
// few rounds.
std::vector<std::uint8_t> filled_faces(std::span<const Vec3> vertices,
                                       std::span<const Triangle> triangles,
                                       const MeshTopology& topology, const FaceGaps& gaps);

// The faces with flag 0, and the vertices they use, both in their order.
struct Kept {
  std::vector<Index> vertices, triangles;  // indices into the whole mesh
};
Kept kept_elements(const Mesh& mesh, const std::vector<std::uint8_t>& filled);

// The part of the mesh with these elements, with its attributes.
Mesh extract_part(const Mesh& mesh, const Kept& kept);

}  // namespace arris
