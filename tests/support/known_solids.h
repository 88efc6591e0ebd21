// Solids whose signed distance is known by formula, and samples of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "support/samplers.h"
#include "support/shapes.h"
#include "support/tetra.h"

namespace arris::test {

struct KnownSolid {
  std::string name;
  std::vector<Vec3> samples;
  std::function<double(Vec3)> distance;  // negative inside
};

inline double box_distance(Vec3 p, double low, double high) {
  const double c = 0.5 * (low + high), r = 0.5 * (high - low);
  const Vec3 q{std::abs(p.x - c) - r, std::abs(p.y - c) - r, std::abs(p.z - c) - r};
  const Vec3 out{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
  return length(out) + std::min(0.0, std::max({q.x, q.y, q.z}));
}

inline std::vector<KnownSolid> known_solids(std::size_t n) {
  const auto sphere_distance = [](Vec3 p) { return length(p) - 1; };
  std::vector<Vec3> pair = sample_blue(sphere().mesh, n / 2, 1);
  for (Vec3 p : sample_blue(sphere().mesh, n / 2, 2)) pair.push_back(p + Vec3{3, 0.5, 0});
  return {
      {"sphere", sample_blue(sphere().mesh, n, 1), sphere_distance},
      {"cube", sample_feature(cube().mesh, n, 1), [](Vec3 p) { return box_distance(p, 0, 1); }},
      {"torus", sample_blue(torus().mesh, n, 1),
       [](Vec3 p) { return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.4; }},
      {"nested shells", sample_feature(nested_shells().mesh, n, 1),
       [](Vec3 p) {
         const double hollow = std::max(box_distance(p, 0, 5), -box_distance(p, 1, 4));
         return std::min(hollow, box_distance(p, 2, 3));
       }},
      {"two balls", pair,
       [sphere_distance](Vec3 p) {
         return std::min(sphere_distance(p), sphere_distance(p - Vec3{3, 0.5, 0}));
       }},
  };
}

inline Vec3 centroid_of(const TetMesh& mesh, Tet t) {
  Vec3 c;
  for (Index v : mesh.vertices[t]) c = c + 0.25 * mesh.points[v];
  return c;
}

}  // namespace arris::test
