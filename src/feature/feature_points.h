// Points on edges and corners that no sample lies on, where sensed surfaces meet.
#pragma once

#include <vector>

#include "feature/sense.h"

namespace arris {

struct FeaturePoint {
  Vec3 position;
  double spacing = 0;   // h there
  bool corner = false;
  std::vector<LocalSurface> surfaces;  // that meet there
};

// Appends to `features`, which holds what earlier rounds found; points[samples ..] are their
// positions.
void find_feature_points(const std::vector<Vec3>& points, const FacetMesh& mesh,
                         const std::vector<double>& spacing, const Sensed& sensed,
                         std::vector<FeaturePoint>& features, Job& job);

}  // namespace arris
