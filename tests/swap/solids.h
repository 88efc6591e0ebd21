// Solids with known total mean curvature, sampled also on their edges and corners.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/vec.h"

namespace arris::test {

struct Solid {
  std::string name;
  std::vector<Vec3> samples;
  double spacing = 0;
  std::function<bool(Vec3)> inside;
  double curvature = 0;  // true total mean curvature, Σ l |π - θ| / 2 or ∫ |κ| ds
  Vec3 centre;           // sees all of the solid
};

// A polyhedron as corners and faces; a face is one simple loop of corners, convex or not.
struct Polyhedron {
  std::vector<Vec3> corners;
  std::vector<std::vector<std::size_t>> faces;
};

// Is p, in the plane of the loop, inside it? Parity of the edges crossed in the projection along
// the largest component of the normal.
inline bool in_loop(const std::vector<Vec3>& loop, Vec3 normal, Vec3 p) {
  const double ax = std::abs(normal.x), ay = std::abs(normal.y), az = std::abs(normal.z);
  const auto flat = [&](Vec3 q) {
    return ax >= ay && ax >= az ? std::pair(q.y, q.z)
           : ay >= az           ? std::pair(q.z, q.x)
                                : std::pair(q.x, q.y);
  };
  const auto [pu, pv] = flat(p);
  bool inside = false;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const auto [au, av] = flat(loop[k]);
    const auto [bu, bv] = flat(loop[(k + 1) % loop.size()]);
    if ((av > pv) != (bv > pv) && pu < (bu - au) * (pv - av) / (bv - av) + au) inside = !inside;
  }
  return inside;
}

inline double distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const double s = std::clamp(dot(p - a, b - a) / squared_length(b - a), 0.0, 1.0);
  return distance(p, a + s * (b - a));
}

// Corners, points along the edges, and a jittered grid on the faces, all about h apart.
inline std::vector<Vec3> sample(const Polyhedron& polyhedron, double h, unsigned seed) {
  constexpr double jitter = 0.3, margin = 0.5;  // in units of h
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> offset(-jitter * h, jitter * h);
  std::vector<Vec3> points = polyhedron.corners;
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& face : polyhedron.faces) {
    std::vector<Vec3> loop;
    for (std::size_t c : face) loop.push_back(polyhedron.corners[c]);
    Vec3 normal;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::size_t next = (k + 1) % loop.size();
      normal = normal + cross(loop[k], loop[next]);
      if (!edges.insert(std::minmax(face[k], face[next])).second) continue;
      const int n = static_cast<int>(std::lround(distance(loop[k], loop[next]) / h));
      for (int i = 1; i < n; ++i) points.push_back(loop[k] + 1.0 * i / n * (loop[next] - loop[k]));
    }
    const Vec3 u = 1 / distance(loop[1], loop[0]) * (loop[1] - loop[0]);
    const Vec3 v = 1 / length(cross(normal, u)) * cross(normal, u);
    double reach = 0;
    for (Vec3 p : loop) reach = std::max(reach, distance(p, loop[0]));
    const int n = static_cast<int>(reach / h) + 1;
    for (int i = -n; i <= n; ++i)
      for (int j = -n; j <= n; ++j) {
        const Vec3 p = loop[0] + (h * i + offset(random)) * u + (h * j + offset(random)) * v;
        double to_edge = margin * h;
        for (std::size_t k = 0; k < loop.size(); ++k)
          to_edge = std::min(to_edge, distance_to_segment(p, loop[k], loop[(k + 1) % loop.size()]));
        if (to_edge >= margin * h && in_loop(loop, normal, p)) points.push_back(p);
      }
  }
  return points;
}

inline Polyhedron box(Vec3 low, Vec3 high) {
  Polyhedron b;
  for (int k = 0; k < 8; ++k)
    b.corners.push_back({(k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y,
                         (k & 4) != 0 ? high.z : low.z});
  b.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return b;
}

inline bool in_box(Vec3 p, double low, double high) {
  return std::min({p.x, p.y, p.z}) > low && std::max({p.x, p.y, p.z}) < high;
}

// 12 edges of length 1 that turn by pi/2: 3 pi.
inline Solid cube(double h) {
  return {"cube",
          sample(box({0, 0, 0}, {1, 1, 1}), h, 1),
          h,
          [](Vec3 p) { return in_box(p, 0, 1); },
          3 * std::numbers::pi,
          {0.5, 0.5, 0.5}};
}

// [0,1]^3 and [1/2,3/2]^3. Each loses three half edges at the corner that is inside the other:
// 21 of convex edges; they meet in a hexagon of six half edges, 3 of reentrant ones. All turn by
// pi/2: 24 x pi/4 = 6 pi.
inline Solid two_cubes(double h) {
  Polyhedron p = box({0, 0, 0}, {1, 1, 1});
  const Polyhedron second = box({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5});
  p.corners.pop_back();  // (1,1,1), index 7
  p.corners.insert(p.corners.end(), second.corners.begin() + 1, second.corners.end());  // 7..13
  // The hexagon: where the edges of one cube at its buried corner pierce the faces of the other.
  const std::size_t x = p.corners.size();
  for (Vec3 c : {Vec3{1, 1, 0.5}, Vec3{1, 0.5, 1}, Vec3{0.5, 1, 1}, Vec3{0.5, 0.5, 1},
                 Vec3{0.5, 1, 0.5}, Vec3{1, 0.5, 0.5}})
    p.corners.push_back(c);
  const std::size_t a = x, b = x + 1, c = x + 2, d = x + 3, e = x + 4, f = x + 5;
  p.faces = {{0, 2, 3, 1},
             {0, 1, 5, 4},
             {0, 4, 6, 2},  // the first cube: low sides
             {4, 5, b, d, c, 6},
             {2, 6, c, e, a, 3},
             {1, 3, a, f, b, 5},  // and notched high sides
             // The second: corners k = 1..7 of its box are at 6 + k.
             {10, 11, 13, 12},
             {8, 12, 13, 9},
             {7, 9, 13, 11},
             {f, a, e, 8, 9, 7},
             {f, 7, 11, 10, d, b},
             {d, 10, 12, 8, e, c}};
  return {"two cubes",
          sample(p, h, 2),
          h,
          [](Vec3 q) { return in_box(q, 0, 1) || in_box(q, 0.5, 1.5); },
          6 * std::numbers::pi,
          {0.75, 0.75, 0.75}};
}

// |x| + |y| + |z| < 1: 12 edges of length sqrt 2 that turn by acos(1/3).
inline Solid octahedron(double h) {
  Polyhedron p;
  p.corners = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  p.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
             {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return {"octahedron",
          sample(p, h, 3),
          h,
          [](Vec3 q) { return std::abs(q.x) + std::abs(q.y) + std::abs(q.z) < 1 - 1e-9; },
          6 * std::numbers::sqrt2 * std::acos(1.0 / 3),
          {}};
}

// An L extruded by 1: outer sides 1, arms 0.4 thick. 5 convex uprights and a reentrant one, and two
// loops of perimeter 4, all turning by pi/2: (6 + 8) pi / 4.
inline Solid l_prism(double h) {
  Polyhedron p;
  const std::vector<std::pair<double, double>> outline = {{0, 0},     {1, 0},   {1, 0.4},
                                                          {0.4, 0.4}, {0.4, 1}, {0, 1}};
  for (double z : {0.0, 1.0})
    for (auto [x, y] : outline) p.corners.push_back({x, y, z});
  p.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  for (std::size_t k = 0; k < 6; ++k) p.faces.push_back({k, (k + 1) % 6, (k + 1) % 6 + 6, k + 6});
  return {"L prism",
          sample(p, h, 4),
          h,
          [](Vec3 q) { return in_box(q, 0, 1) && (q.x < 0.4 || q.y < 0.4); },
          14 * std::numbers::pi / 4,
          {0.2, 0.2, 0.5}};
}

// Fibonacci points, jittered along the sphere.
inline std::vector<Vec3> sphere_points(std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> offset(-0.3, 0.3);
  std::vector<Vec3> points(n);
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (std::size_t k = 0; k < n; ++k) {
    const double z =
        1 - 2 * (static_cast<double>(k) + 0.5 + offset(random)) / static_cast<double>(n);
    const double a =
        golden * static_cast<double>(k) + offset(random) * std::sqrt(4.0 / static_cast<double>(n));
    const double r = std::sqrt(1 - z * z);
    points[k] = {r * std::cos(a), r * std::sin(a), z};
  }
  return points;
}

// The unit ball: 4 pi.
inline Solid ball(double h) {
  const auto n = static_cast<std::size_t>(4 * std::numbers::pi / (h * h));
  return {"ball",
          sphere_points(n, 5),
          h,
          [](Vec3 p) { return squared_length(p) < 1 + 1e-9; },
          4 * std::numbers::pi,
          {}};
}

// A sphere of radius 1 with bumps, star-shaped round the origin; its curvature is not given.
inline Solid bumpy_ball(std::size_t n, unsigned seed) {
  const auto radius = [](Vec3 unit) {
    return 1 + 0.1 * std::sin(5 * unit.x) * std::sin(6 * unit.y) * std::sin(7 * unit.z + 1);
  };
  Solid s{"bumpy ball",
          sphere_points(n, seed),
          std::sqrt(4 * std::numbers::pi / static_cast<double>(n)),
          {},
          0,
          {}};
  for (Vec3& p : s.samples) p = radius(p) * p;
  s.inside = [radius](Vec3 p) {
    const double r = length(p);
    return r == 0 || r < radius(1 / r * p);
  };
  return s;
}

// Radius 1/2, height 1: the side pi (|κ| = 1, area pi), two rims of length pi turning by pi/2:
// pi + 2 pi pi/4.
inline Solid cylinder(double h) {
  const double pi = std::numbers::pi;
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> offset(-0.3, 0.3);
  std::vector<Vec3> points;
  const int round = static_cast<int>(std::lround(pi / h)),
            up = static_cast<int>(std::lround(1 / h));
  for (int j = 0; j <= up; ++j)
    for (int i = 0; i < round; ++i) {
      const bool rim = j == 0 || j == up;
      const double a = 2 * pi * (i + (rim ? 0 : offset(random))) / round;
      points.push_back(
          {0.5 * std::cos(a), 0.5 * std::sin(a), 1.0 * (j + (rim ? 0 : offset(random))) / up});
    }
  for (double z : {0.0, 1.0})
    for (int i = -up; i <= up; ++i)
      for (int j = -up; j <= up; ++j) {
        const double x = h * (i + offset(random)), y = h * (j + offset(random));
        if (std::hypot(x, y) < 0.5 - 0.5 * h) points.push_back({x, y, z});
      }
  return {"cylinder",
          points,
          h,
          [](Vec3 p) { return p.x * p.x + p.y * p.y < 0.25 + 1e-9 && p.z > 0 && p.z < 1; },
          pi + pi * pi / 2,
          {0, 0, 0.5}};
}

}  // namespace arris::test
