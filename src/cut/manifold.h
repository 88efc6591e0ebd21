// Makes the boundary of a labelling a 2-manifold by relabelling few, cheap tetrahedra.
#pragma once

#include <cstdint>
#include <functional>

#include "base/job.h"
#include "tetra/stars.h"
#include "tetra/tet_mesh.h"

namespace arris {

// The boundary is a 2-manifold at vertex v exactly if no curve, or one simple closed curve,
// separates inside from outside on the link of v, which is a sphere. Equivalently, the inside and
// the outside tetrahedra of the star are each connected through facets at v. O(star).
bool is_regular_vertex(const TetMesh& mesh, const Labels& labels, std::span<const Tet> star,
                       Index v);

// Cost of facet i of tetrahedron t in the surface.
using FacetCost = std::function<double(Tet, int)>;

// Where a star is singular, flips that one of its connected parts whose flip raises the cost of the
// surface least, and goes on with the vertices this touched. A tetrahedron may flip only a few
// times; after that parts are only ever carved away, so it ends with a 2-manifold, in the worst
// case an empty one. Infinite tetrahedra keep their label. Returns the number of flips.
std::uint64_t make_manifold(const TetMesh& mesh, const Stars& stars, const FacetCost& cost,
                            Labels& labels, Job& job);

}  // namespace arris
