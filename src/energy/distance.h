// The fidelity term: mean distance of a facet to the samples (paper, eq. 5).
#pragma once

#include "tetra/tet_mesh.h"

namespace arris {

// Area of facet i of tetrahedron t, and the mean over it of the distance to the nearest sample, by
// cubature of degree 3 (vertices, edge midpoints, centroid). The nearest sample is sought among
// those nearest to the five vertices of the two tetrahedra at the facet, which in a Delaunay mesh
// is nearly always enough. The facet must not be infinite.
struct FacetDistance {
  double area = 0;
  double mean_distance = 0;
};
FacetDistance facet_distance(const TetMesh& mesh, Tet t, int i);

}  // namespace arris
