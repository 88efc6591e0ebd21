// Points on edges and corners that no sample lies on, where sensed surfaces meet.
#pragma once

#include <vector>

#include "feature/sense.h"

namespace arris {

struct FeaturePoint {
  Vec3 position;
  double spacing = 0;   // h there
  bool corner = false;
  std::vector<Vec3> normals;  // of the surfaces that meet there
};

// `added`: none of the points from this index on is a sample; they may be replaced.
std::vector<FeaturePoint> feature_points(const std::vector<Vec3>& points, const FacetMesh& mesh,
                                         const std::vector<double>& spacing, const Sensed& sensed,
                                         std::size_t samples, Job& job);

}  // namespace arris
