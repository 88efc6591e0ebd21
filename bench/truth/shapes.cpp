#include "truth/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "base/vec.h"
#include "truth/random.h"
#include "truth/revolution.h"

namespace arris::truth {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double phi = std::numbers::phi;

// All edges of a box complex turn by a right angle, so their total length says the curvature.
double right_angled(double edge_length) {
  return edge_length * pi / 4;
}

// A cube [at, at+side]^3 with square tunnels along its axes that leave bars of width 1.
std::vector<Box> frame(double side, double at) {
  const double a = at, b = at + 1, c = at + side - 1, d = at + side;
  return {{{a, a, a}, {d, d, d}, true},
          {{a, b, b}, {d, c, c}, false},
          {{b, a, b}, {c, d, c}, false},
          {{b, b, a}, {c, c, d}, false}};
}

// All sign combinations of the coordinates of p.
void add_signed(std::vector<Vec3>& points, Vec3 p) {
  for (const double x : {p.x, -p.x})
    for (const double y : {p.y, -p.y})
      for (const double z : {p.z, -p.z})
        if (std::find(points.begin(), points.end(), Vec3{x, y, z}) == points.end())
          points.push_back({x, y, z});
}

std::vector<Vec3> cyclic(Vec3 p) {
  std::vector<Vec3> points;
  add_signed(points, {p.x, p.y, p.z});
  add_signed(points, {p.y, p.z, p.x});
  add_signed(points, {p.z, p.x, p.y});
  return points;
}

}  // namespace

Shape cube() {
  return {"cube", box_complex({{{0, 0, 0}, {1, 1, 1}}}), {1, 2, 1, 6, right_angled(12)}};
}

Shape two_cubes() {
  Mesh mesh = box_complex({{{0, 0, 0}, {1, 1, 1}}, {{0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}}});
  // Each cube loses three half edges inside the other; they meet along six concave half edges.
  return {"two_cubes", std::move(mesh), {1, 2, 1.875, 10.5, right_angled(2 * 10.5 + 3)}};
}

Shape perforated_cube() {
  // Edges: 12 of the cube, 6 rims, 4 concave along each of 6 arms, 12 where the arms meet.
  return {"perforated_cube",
          box_complex(frame(3, 0)),
          {1, -8, 20, 72, right_angled(36 + 24 + 24 + 12)}};
}

Shape l_bracket() {
  Mesh mesh = box_complex({{{0, 0, 0}, {3, 1, 2}}, {{0, 0, 0}, {1, 3, 2}}});
  return {"l_bracket", std::move(mesh), {1, 2, 10, 34, right_angled(36)}};
}

Shape thin_plate() {
  return {
      "thin_plate", box_complex({{{0, 0, 0}, {1, 1, 0.05}}}), {1, 2, 0.05, 2.2, right_angled(8.2)}};
}

Shape tangled_frames() {
  Mesh mesh = box_complex(frame(5, 0));
  const Mesh other = box_complex(frame(5, 2));
  const Index first = static_cast<Index>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return {"tangled_frames",
          std::move(mesh),
          {2, -16, 2 * 44, 2 * 168, right_angled(2 * (60 + 72 + 36 + 24))}};
}

Shape nested_shells() {
  Mesh mesh = box_complex(
      {{{0, 0, 0}, {5, 5, 5}, true}, {{1, 1, 1}, {4, 4, 4}, false}, {{2, 2, 2}, {3, 3, 3}, true}});
  return {"nested_shells", std::move(mesh), {3, 6, 99, 210, right_angled(60 + 36 + 12)}};
}

Shape steps() {
  Mesh mesh = box_complex({{{0, 0, 0}, {3, 2, 1}}, {{0, 0, 1}, {2, 2, 2}}, {{0, 0, 2}, {1, 2, 3}}});
  return {"steps", std::move(mesh), {1, 2, 12, 36, right_angled(24 + 16)}};
}

Shape octahedron() {
  const double turn = pi - std::acos(-1.0 / 3);
  return {"octahedron",
          convex_hull(cyclic({1, 0, 0})),
          {1, 2, 4.0 / 3, 4 * std::sqrt(3.0), 12 * std::sqrt(2.0) * turn / 2}};
}

Shape icosahedron() {
  const double turn = pi - std::acos(-std::sqrt(5.0) / 3);
  return {"icosahedron",
          convex_hull(cyclic({0, 1, phi})),
          {1, 2, 10 * (3 + std::sqrt(5.0)) / 3, 20 * std::sqrt(3.0), 30 * 2 * turn / 2}};
}

Shape dodecahedron() {
  std::vector<Vec3> points = cyclic({0, 1 / phi, phi});
  add_signed(points, {1, 1, 1});
  const double edge = 2 / phi, turn = pi - std::acos(-1 / std::sqrt(5.0));
  return {"dodecahedron",
          convex_hull(points),
          {1, 2, (15 + 7 * std::sqrt(5.0)) / 4 * edge * edge * edge,
           3 * std::sqrt(25 + 10 * std::sqrt(5.0)) * edge * edge, 30 * edge * turn / 2}};
}

Shape hexagonal_prism() {
  std::vector<Vec3> points;
  const double y = std::sqrt(3.0) / 2;
  for (const double z : {0.0, 1.0})
    for (const Vec3 p :
         {Vec3{1, 0, z}, {0.5, y, z}, {-0.5, y, z}, {-1, 0, z}, {-0.5, -y, z}, {0.5, -y, z}})
      points.push_back(p);
  return {"hexagonal_prism",
          convex_hull(points),
          {1, 2, 3 * y, 6 * y + 6, 12 * (pi / 2) / 2 + 6 * (pi / 3) / 2}};
}

Shape wedge() {
  std::vector<Vec3> points;
  for (const double y : {0.0, 1.0})
    for (const Vec3 p : {Vec3{0, y, 0}, {2, y, 0}, {0, y, 1}}) points.push_back(p);
  const double perimeter = 3 + std::sqrt(5.0);
  return {"wedge",
          convex_hull(points),
          {1, 2, 1, 2 + perimeter, 2 * perimeter * (pi / 2) / 2 + 2 * pi / 2}};
}

Shape sphere() {
  return {"sphere",
          revolve(arc(0, 0, 1, -pi / 2, pi / 2, 60), 120),
          {1, 2, 4 * pi / 3, 4 * pi, 4 * pi, true}};
}

Shape torus() {
  const double big = 1, small = 0.4;
  // |k1| = 1 / small gives the first term, |k2| = |cos t| / (big + small cos t) the second.
  return {"torus",
          revolve_loop(arc(big, 0, small, 0, 2 * pi, 72), 144),
          {1, 0, 2 * pi * pi * big * small * small, 4 * pi * pi * big * small,
           2 * pi * pi * big + 4 * pi * small, true}};
}

Shape cylinder() {
  const double r = 0.5, h = 1;
  return {"cylinder",
          revolve({{0, 0}, {r, 0}, {r, h}, {0, h}}, 120),
          {1, 2, pi * r * r * h, 2 * pi * r * (r + h), pi * h + pi * pi * r, true}};
}

Shape cone() {
  const double r = 0.5, h = 1, slant = std::hypot(r, h);
  return {"cone",
          revolve({{0, 0}, {r, 0}, {0, h}}, 120),
          {1, 2, pi * r * r * h / 3, pi * r * (r + slant),
           pi * h + pi * r * (pi - std::atan2(h, r)), true}};
}

std::vector<Shape> all_shapes() {
  return {cube(),       two_cubes(),      perforated_cube(), l_bracket(),
          thin_plate(), tangled_frames(), nested_shells(),   steps(),
          octahedron(), icosahedron(),    dodecahedron(),    hexagonal_prism(),
          wedge(),      sphere(),         torus(),           cylinder(),
          cone()};
}

Shape make_shape(std::string_view name) {
  for (Shape& shape : all_shapes())
    if (shape.name == name) return std::move(shape);
  throw std::out_of_range("no shape has that name");
}

Mesh moved(Mesh mesh, std::uint64_t seed, double scale, Vec3 shift) {
  Random random(seed);
  // A uniform unit quaternion, by rejection.
  std::array<double, 4> q{};
  double norm = 0;
  do {
    norm = 0;
    for (double& c : q) c = 2 * random.unit() - 1, norm += c * c;
  } while (norm > 1 || norm < 1e-3);
  const Vec3 axis = {q[1], q[2], q[3]};
  for (Vec3& p : mesh.vertices) {
    const Vec3 t = cross(axis, p);
    p = scale * (p + (2 / norm) * (q[0] * t + cross(axis, t))) + shift;
  }
  return mesh;
}

}  // namespace arris::truth
