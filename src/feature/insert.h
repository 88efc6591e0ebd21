// Points to add on edges and corners that no sample lies on.
#pragma once

#include <vector>

#include "base/job.h"
#include "feature/candidates.h"

namespace arris {

// Feature points for one more round, appended to `features`, which holds those of earlier rounds:
// points[samples ..]. Corners first, then points on edges, thinned; where a sample lies on the
// feature already none is added. Then the gaps are split until the Delaunay triangulation has to
// follow the curves (protect.h). `mesh` is a surface over all points, `spacing` h per point.
// Across gaps of the samples none is added within the width of the gap of a `refused` one.
// Deterministic. O(facets) apart from searches, O(log points) each.
void insert_feature_points(const std::vector<Vec3>& points, std::size_t samples,
                           const FacetMesh& mesh, const std::vector<double>& spacing,
                           const Sensed& sensed, const std::vector<FeaturePoint>& refused,
                           std::vector<FeaturePoint>& features, Job& job);

}  // namespace arris
