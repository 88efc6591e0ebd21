// Facet normals without the noise of the points.
#pragma once

#include <vector>

#include "feature/facets.h"

namespace arris {

struct FilteredNormals {
  std::vector<Vec3> normal;  // per facet, unit, outward; zero if all round it are slivers
  std::vector<double>
      likeness;  // per facet: normals that differ by this chord lost 40 % of their say
};

// Means over the facets that share a point, weighted by area, nearness and likeness, again and
// again: normals of one smooth piece come to agree, those across an edge stay apart. After Zhang,
// Deng, Zhang, Bouaziz, Liu, "Guided mesh normal filtering" (2015): alike are facets whose
// guidances are, the mean normals of the least varying neighbourhoods that hold them, which a
// single wrong facet does not sway. `points` are those of the mesh.
// O(facets) for bounded degrees, in parallel; the same for any number of threads.
FilteredNormals filter_normals(const std::vector<Vec3>& points, const FacetMesh& mesh,
                               unsigned threads);

}  // namespace arris
