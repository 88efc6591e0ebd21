// Where a mesh made by code is sharp: what inserted points are held against.
#pragma once

#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

#include "base/vec.h"
#include "truth/feature_graph.h"

namespace arris::test {

// The edges at which a mesh turns by more than 30 degrees, and their corners.
class Creases {
 public:
  explicit Creases(const Mesh& mesh) : mesh_(mesh) {
    const truth::FeatureGraph graph = truth::feature_graph(mesh, std::numbers::pi / 6);
    edges_ = graph.sharp;
    for (Index v = 0; v < mesh.vertices.size(); ++v)
      if (graph.corner[v]) corners_.push_back(mesh.vertices[v]);
  }

  const std::vector<Vec3>& corners() const { return corners_; }

  // Distance to the nearest edge; infinite if there is none.
  double distance_from(Vec3 p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const truth::SharpEdge& e : edges_) {
      const Vec3 a = mesh_.vertices[e.a], along = mesh_.vertices[e.b] - a;
      const double share = std::clamp(dot(p - a, along) / squared_length(along), 0.0, 1.0);
      least = std::min(least, distance(p, a + share * along));
    }
    return least;
  }

 private:
  Mesh mesh_;
  std::vector<truth::SharpEdge> edges_;
  std::vector<Vec3> corners_;
};

}  // namespace arris::test
