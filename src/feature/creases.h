// Which edges of a mesh are sharp: judged one by one, against the curvature round about.
#pragma once

#include <cstdint>
#include <vector>

#include "arris/types.h"
#include "base/job.h"
#include "feature/mesh_edges.h"

namespace arris {

// What an edge is on its own evidence. Noise makes strong edges too, here and there; it hardly
// makes clear ones.
enum class Crease : std::uint8_t { none, weak, strong, clear };

// Per edge. Where a surface of curvature k is sampled, it turns by k times the distance of the
// circumcentres at an edge; a crease turns by far more than that. The curvature across the edge is
// measured on either side of it by the normal cycle (Cohen-Steiner and Morvan, "Restricted Delaunay
// triangulations and normal cycle", 2003) over faces within two edge lengths, with the absolute
// values of all angles, so that noise raises it as well; the larger side counts.
// O(n), parallel.
std::vector<Crease> judge_edges(const Mesh& mesh, const MeshEdges& edges, Job& job);

// Lines of edges that are not `none`, each going on from the last roughly straight and with the
// same sign of turning: those that hold a clear edge, or several edges of which some are strong. 1
// per edge chosen. O(n log n).
std::vector<std::uint8_t> connect_creases(const Mesh& mesh, const MeshEdges& edges,
                                          const std::vector<Crease>& crease);

}  // namespace arris
