// What rays hit: triangles and balls, by Embree. The only file of the viewer that knows Embree.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "arris/types.h"
#include "viewer/camera.h"

namespace arris::viewer {

struct Hit {
  double distance = 0;  // along the ray
  Vec3 normal;          // length 1 (or 0 for a degenerate triangle), outwards
  bool ball = false;
};

// A model in the unit ball: triangles over points, and balls of one radius round points.
struct Model {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<Vec3> balls;
  double ball_radius = 0;
};

// Refers to the model. Queries may run on several threads at once. Embree, in single precision,
// only says which triangle or ball is hit; where and how is computed here in doubles.
class RayScene {
 public:
  // Throws std::bad_alloc, or std::runtime_error if Embree fails.
  explicit RayScene(const Model& model);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  std::optional<Hit> nearest(const Ray& ray) const;
  // Is anything nearer than `limit` along the ray?
  bool blocked(const Ray& ray, double limit) const;

 private:
  struct Embree;
  const Model& model_;
  std::unique_ptr<Embree> embree_;
};

}  // namespace arris::viewer
