// Labels with a 2-manifold boundary to start from: grown and disturbed by simple flips alone.
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "base/vec.h"
#include "swap/boundary.h"
#include "swap/solids.h"

namespace arris::test {

inline Vec3 centroid(const TetMesh& mesh, Tet t) {
  Vec3 c;
  for (Index v : mesh.vertices[t]) c = c + 0.25 * mesh.points[v];
  return c;
}

// Tetrahedra whose centroid is inside.
inline Labels centroid_labels(const TetMesh& mesh, const Solid& solid) {
  Labels labels(mesh.size(), 0);
  for (Tet t = 0; t < mesh.finite; ++t) labels[t] = solid.inside(centroid(mesh, t));
  return labels;
}

// Power of the point p with respect to the circumsphere of t.
inline double power(const TetMesh& mesh, Tet t, Vec3 p) {
  const auto& c = mesh.vertices[t];
  const Vec3 a = mesh.points[c[0]], u = mesh.points[c[1]] - a, v = mesh.points[c[2]] - a,
             w = mesh.points[c[3]] - a;
  const Vec3 numerator = squared_length(u) * cross(v, w) + squared_length(v) * cross(w, u) +
                         squared_length(w) * cross(u, v);
  const Vec3 centre = 0.5 / dot(u, cross(v, w)) * numerator;  // from a
  return squared_length(p - a) - 2 * dot(p - a, centre);
}

// A topological ball of tetrahedra whose centroid is inside, added by simple flips alone. Sorted by
// the power of a point that sees all of the solid, the tetrahedra of a Delaunay mesh are a shelling
// (Edelsbrunner 1990), so nearly all flips are simple when their turn comes.
inline Labels grow_ball(const TetMesh& mesh, const Solid& solid) {
  const Labels inside = centroid_labels(mesh, solid);
  std::vector<std::pair<double, Tet>> order;
  for (Tet t = 0; t < mesh.finite; ++t)
    if (inside[t] != 0) order.emplace_back(power(mesh, t, solid.centre), t);
  std::sort(order.begin(), order.end());
  Labels labels(mesh.size(), 0);
  if (order.empty()) return labels;
  labels[order.front().second] = 1;
  Boundary boundary(mesh, labels);
  for (bool grown = true; grown;) {
    grown = false;
    for (const auto& [key, t] : order)
      if (labels[t] == 0 && boundary.is_simple(t)) {
        boundary.flip(t);
        grown = true;
      }
  }
  return labels;
}

// Up to `count` random simple flips.
inline void disturb(const TetMesh& mesh, std::size_t count, unsigned seed, Labels& labels) {
  constexpr int tries_per_flip = 400;
  Boundary boundary(mesh, labels);
  std::mt19937_64 random(seed);
  for (std::size_t tries = 0; count > 0 && tries < tries_per_flip * mesh.finite; ++tries) {
    const auto t = static_cast<Tet>(random() % mesh.finite);
    // Flips that take a vertex off the surface lead away fastest: let one in four through.
    if (!boundary.is_simple(t) || (boundary.removed_vertex(t) != no_index && random() % 4 != 0))
      continue;
    boundary.flip(t);
    --count;
  }
}

}  // namespace arris::test
