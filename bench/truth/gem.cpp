// Convex polyhedra of the paper's Figure 9.
#include <cmath>
#include <numbers>
#include <vector>

#include "base/vec.h"
#include "truth/paper_models.h"
#include "truth/shapes.h"

namespace arris::truth {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double phi = std::numbers::phi;

Vec3 on_circle(double radius, double eighths, double height) {
  const double angle = eighths * pi / 4;
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

// All cyclic permutations and signs of the coordinates of p, without repetition.
void add_family(std::vector<Vec3>& points, Vec3 p) {
  for (const Vec3 q : {p, Vec3{p.y, p.z, p.x}, Vec3{p.z, p.x, p.y}})
    for (const double x : {q.x, -q.x})
      for (const double y : {q.y, -q.y})
        for (const double z : {q.z, -q.z}) {
          if ((q.x == 0 && std::signbit(x)) || (q.y == 0 && std::signbit(y)) ||
              (q.z == 0 && std::signbit(z)))
            continue;
          points.push_back({x, y, z});
        }
}

}  // namespace

Mesh buckyball() {
  std::vector<Vec3> points;
  add_family(points, {0, 1, 3 * phi});
  add_family(points, {1, 2 + phi, 2 * phi});
  add_family(points, {2, 1 + 2 * phi, phi});
  return convex_hull(points);
}

// Angles and shares as jewellers cut them; the girdle has radius 1. Bezel facet k (a kite) touches
// the table in its corner k and the girdle at angle k; neighbours meet along a line of slope
// tan(crown) cos(pi/8), on which a star facet ends. The pavilion is alike, with the culet on top.
Mesh brilliant_diamond() {
  constexpr double crown = 34.5 * pi / 180, pavilion = 40.75 * pi / 180;
  constexpr double table = 0.53, star = 0.72, lower = 0.35;  // radii of table, star and lower ends
  constexpr double girdle = 0.02;                            // half its height
  const double half_step = std::cos(pi / 8);
  // Heights on the plane of a bezel (or pavilion main) facet at `along` on its axis.
  const auto crown_height = [&](double along) { return girdle + (1 - along) * std::tan(crown); };
  const auto pavilion_depth = [&](double along) {
    return girdle + (1 - along) * std::tan(pavilion);
  };
  std::vector<Vec3> points = {{0, 0, -pavilion_depth(0)}};
  for (int k = 0; k < 8; ++k) {
    points.push_back(on_circle(table, k, crown_height(table)));
    points.push_back(on_circle(star, k + 0.5, crown_height(star * half_step)));
    points.push_back(on_circle(lower, k + 0.5, -pavilion_depth(lower * half_step)));
    for (const double k2 : {k + 0.0, k + 0.5}) {
      points.push_back(on_circle(1, k2, girdle));
      points.push_back(on_circle(1, k2, -girdle));
    }
  }
  return convex_hull(points);
}

}  // namespace arris::truth
