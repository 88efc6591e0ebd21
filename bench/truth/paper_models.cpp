#include "truth/paper_models.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "base/vec.h"
#include "truth/boolean.h"
#include "truth/must.h"
#include "truth/revolution.h"
#include "truth/shapes.h"

namespace arris::truth {
namespace {

constexpr double pi = std::numbers::pi;

Mesh unite(const Mesh& a, const Mesh& b) {
  return must(combine(a, b, Operation::unite));
}

Mesh subtract(const Mesh& a, const Mesh& b) {
  return must(combine(a, b, Operation::subtract));
}

Mesh box(Vec3 low, Vec3 high) {
  return box_complex({{low, high}});
}

Mesh shifted(Mesh mesh, Vec3 by) {
  for (Vec3& p : mesh.vertices) p = p + by;
  return mesh;
}

// Coordinates (x, y, z) become (z, x, y): what stood along z lies along x. A second time: along y.
Mesh axes_turned(Mesh mesh) {
  for (Vec3& p : mesh.vertices) p = {p.z, p.x, p.y};
  return mesh;
}

Mesh cylinder_between(double radius, double low, double high, int resolution) {
  return revolve({{0, low}, {radius, low}, {radius, high}, {0, high}}, resolution);
}

// Along the arc of the circle (0, height, r), for revolve, without its first point.
void append_arc(std::vector<ProfilePoint>& profile, double height, double r, double from, double to,
                int segments) {
  const std::vector<ProfilePoint> points = arc(0, height, r, from, to, segments);
  profile.insert(profile.end(), points.begin() + 1, points.end());
}

}  // namespace

// Both are centred on the z axis, so the circle in which they meet is a vertex of the profile.
Mesh two_spheres(int resolution) {
  constexpr double big = 1, small = 0.85, apart = 1.15;
  const double meet = (big * big - small * small + apart * apart) / (2 * apart);
  const double lower_end = std::asin(meet / big), upper_start = std::asin((meet - apart) / small);
  std::vector<ProfilePoint> profile = arc(0, 0, big, -pi / 2, lower_end, resolution / 2);
  append_arc(profile, apart, small, upper_start, pi / 2, resolution / 2);
  return revolve(profile, resolution);
}

Mesh male_symbol(int resolution) {
  constexpr double half = 0.2;  // half the thickness of all parts
  const Mesh ring =
      revolve_loop({{0.7, -half}, {1, -half}, {1, half}, {0.7, half}, {0.7, -half}}, resolution);
  const Mesh bar = box({0.85, -0.12, -half * 0.75}, {1.9, 0.12, half * 0.75});
  std::vector<Vec3> head;
  for (const double z : {-half, half})
    for (const Vec3 p : {Vec3{1.7, -0.4, z}, {2.3, 0, z}, {1.7, 0.4, z}}) head.push_back(p);
  return unite(unite(ring, bar), convex_hull(head));
}

Mesh female_symbol(int resolution) {
  const Mesh ring =
      turned_about_z(revolve_loop(arc(1, 0, 0.2, 0.1, 2 * pi + 0.1, resolution / 2), resolution),
                     0.31 * 2 * pi / resolution);
  const auto bar = [&](double radius, double low, double high, double steps) {
    return turned_about_z(cylinder_between(radius, low, high, resolution / 2),
                          4 * pi * steps / resolution);
  };
  const Mesh stem = axes_turned(bar(0.16, 1.05, 2.2, 0.17));
  const Mesh cross = shifted(axes_turned(axes_turned(bar(0.12, -0.5, 0.5, 0.43))), {1.7, 0, 0});
  return unite(unite(ring, stem), cross);
}

Mesh power_wheel(int resolution) {
  constexpr int teeth = 10;
  // Half the section of the wheel, bored: hub, web with a groove on both sides, rim.
  Mesh wheel = revolve_loop({{0.16, -0.45},
                             {0.38, -0.45},
                             {0.38, -0.12},
                             {0.72, -0.12},
                             {0.72, -0.25},
                             {0.95, -0.25},
                             {0.95, 0.25},
                             {0.72, 0.25},
                             {0.72, 0.12},
                             {0.38, 0.12},
                             {0.38, 0.45},
                             {0.16, 0.45},
                             {0.16, -0.45}},
                            resolution);
  for (int i = 0; i < teeth; ++i) {
    const double angle = 2 * pi * (i + 0.25) / teeth, c = std::cos(angle), s = std::sin(angle);
    std::vector<Vec3> tooth;
    for (const double z : {-0.2, 0.2})
      for (const Vec3 p : {Vec3{0.85, -0.16, z}, {1.2, -0.1, z}, {1.2, 0.1, z}, {0.85, 0.16, z}})
        tooth.push_back({c * p.x - s * p.y, s * p.x + c * p.y, z});
    wheel = unite(wheel, convex_hull(tooth));
  }
  return wheel;
}

// The piriform: the height is cos t, the radius sin t sin(t/2), so that near the tip both the
// radius and the distance from it grow as t squared, at the same rate.
Mesh tear_drop(int resolution) {
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= resolution; ++i) {
    const double t = pi * (1 - static_cast<double>(i) / resolution);
    profile.push_back({std::sin(t) * std::sin(t / 2), std::cos(t)});
  }
  return revolve(profile, resolution);
}

Mesh dumb_bell(int resolution) {
  constexpr double ball = 0.5, bar = 0.16, apart = 1.6;
  const double end = std::acos(bar / ball);  // where the bar meets the ball
  std::vector<ProfilePoint> profile = arc(0, 0, ball, -pi / 2, end, resolution / 2);
  for (const ProfilePoint p : arc(0, apart, ball, -end, pi / 2, resolution / 2))
    profile.push_back(p);
  return revolve(profile, resolution);
}

Mesh drilled_bracket(int resolution) {
  Mesh bracket = box_complex({{{0, 0, 0}, {3, 2, 0.6}}, {{0, 0, 0}, {0.6, 2, 2.4}}});
  for (const double y : {0.55, 1.45}) {
    bracket = subtract(bracket, shifted(cylinder_between(0.28, -1, 2, resolution), {2.2, y, 0}));
    bracket = subtract(
        bracket, shifted(axes_turned(cylinder_between(0.28, -1, 2, resolution)), {0, y, 1.6}));
  }
  return bracket;
}

}  // namespace arris::truth
