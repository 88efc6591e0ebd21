// Tetrahedra between sensed surfaces: what is inside of all surfaces at its corners is inside.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/job.h"
#include "feature/local_surface.h"
#include "seed/seeds.h"
#include "tetra/tet_mesh.h"

namespace arris {

// The surfaces at a point; none where nothing is known.
using SurfacesAt = std::function<std::span<const LocalSurface>(Index)>;

// Per finite tetrahedron: inside or outside if its centroid is clearly on that side of every
// surface at every corner, and the corners are near enough for the surfaces to hold; else free.
// Narrow wedges of material or air, which are cheaper to cut off than to follow, are told so.
// `roughness`: a length by which samples lie off the surface. O(tetrahedra).
std::vector<Seed> tetrahedra_between(const TetMesh& mesh, const std::vector<double>& spacing,
                                     const SurfacesAt& surfaces_at, double roughness, Job& job);

}  // namespace arris
