// Small meshes for tests, all closed and walked counter-clockwise seen from outside.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "arris/types.h"
#include "base/vec.h"

namespace arris::shapes {

inline Mesh tetrahedron() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

// The box [lo, lo + size]^3; vertex i has its bits as coordinates, x lowest.
inline Mesh cube(Vec3 lo = {0, 0, 0}, double size = 1) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back(lo + size * Vec3{double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

// Radii 2 and 1, `n` by `n` quadrilaterals cut in two.
inline Mesh torus(Index n) {
  Mesh mesh;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * j / n;
      const double r = 2 + std::cos(v);
      mesh.vertices.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
      const Index a = i * n + j, b = (i + 1) % n * n + j;
      const Index c = (i + 1) % n * n + (j + 1) % n, d = i * n + (j + 1) % n;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

// An open n by n grid of unit squares in the plane z = 0, facing up.
inline Mesh grid(Index n) {
  Mesh mesh;
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= n; ++j) mesh.vertices.push_back({double(i), double(j), 0});
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      const Index a = i * (n + 1) + j, b = a + n + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  }
  return mesh;
}

inline Mesh reversed(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

inline Mesh moved(Mesh mesh, Vec3 by) {
  for (Vec3& p : mesh.vertices) p = p + by;
  return mesh;
}

inline Mesh scaled(Mesh mesh, double by) {
  for (Vec3& p : mesh.vertices) p = by * p;
  return mesh;
}

// Both meshes, sharing nothing.
inline Mesh joined(Mesh a, const Mesh& b) {
  const auto offset = static_cast<Index>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (Triangle t : b.triangles)
    a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

}  // namespace arris::shapes
