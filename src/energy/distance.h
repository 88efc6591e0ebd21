// The fidelity term: mean distance of a facet to the samples (paper, eq. 5).
#pragma once

#include "tetra/tet_mesh.h"

namespace arris {

// Area of facet i of tetrahedron t, and the mean over it of the distance to the nearest sample. The
// nearest sample is sought among those nearest to the five vertices of the two tetrahedra at the
// facet, which in a Delaunay mesh is nearly always enough. The facet must not be infinite.
//
// The integral is exact (a Voronoi diagram of the three corners) where the corners are the nearest
// samples, and within 2 % elsewhere. This accuracy matters: the integral of d over a flat region
// is the same for every triangulation of it, so a minimizer of E lives on what the cubature gets
// wrong, and a rule with an error of some per cent makes it dig pits into smooth surfaces.
struct FacetDistance {
  double area = 0;
  double mean_distance = 0;
};
FacetDistance facet_distance(const TetMesh& mesh, Tet t, int i);

}  // namespace arris
