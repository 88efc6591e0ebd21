#include "surface/triangle_intersection.h"

#include <cmath>
#include <cstddef>

#include "base/vec.h"
#include "tetra/predicates.h"

namespace arris {
namespace {

// The three sides by corner. Triangles are turned so that shared corners come first; then the sides
// that hold all shared corners are, by the number of shared corners: all; {0, 1} and {2, 0}; {0,
// 1}.
constexpr std::array<std::array<std::size_t, 2>, 3> sides = {{{0, 1}, {2, 0}, {1, 2}}};
constexpr std::array<std::size_t, 3> sides_through_shared = {3, 2, 1};

// All of `points` lie strictly beyond the line of side s, seen from f, in the projection of f.
bool beyond_side(const Facet& f, std::size_t s, std::span<const Vec3> points) {
  for (Vec3 p : points)
    if (orient2d(f.corner[sides[s][0]], f.corner[sides[s][1]], p, f.axis) != -f.turn) return false;
  return true;
}

// A line of a side of f parts f from the other triangle but for the shared corners, in projection
// and so in space. `points` are the corners of the other that are not shared.
bool parted_by_side(const Facet& f, std::size_t shared, std::span<const Vec3> points) {
  for (std::size_t s = 0; s < sides_through_shared[shared]; ++s)
    if (beyond_side(f, s, points)) return true;
  return false;
}

// Relative error of normal . (p - corner) against permanent . |p - corner|: eight
// roundings, half of them in `normal`; doubled for safety. u = 2^-53.
constexpr double plane_error = 16 * 0x1p-53;
// What underflow may add, generously; relative to 1 + |p - corner|.
constexpr double plane_underflow = 1e-300;

// plane_side if rounded arithmetic is certain of it, else 0. Inline and cheap.
inline int certain_plane_side(const Facet& f, Vec3 p) {
  const Vec3 d = p - f.corner[0];
  const Vec3 magnitude{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
  const double value = dot(f.normal, d), permanent = dot(f.permanent, magnitude);
  const double bound =
      plane_error * permanent + plane_underflow * (1 + magnitude.x + magnitude.y + magnitude.z);
  if (!std::isfinite(permanent)) return 0;
  return value > bound ? 1 : -value > bound ? -1 : 0;
}

// All of `points` are certainly strictly on one side of the plane of f.
bool certainly_clear(const Facet& f, std::span<const Vec3> points) {
  const int side = certain_plane_side(f, points[0]);
  if (side == 0) return false;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (certain_plane_side(f, points[i]) != side) return false;
  return true;
}

int plane_side(const Facet& f, Vec3 p) {
  return orient3d(f.corner[0], f.corner[1], f.corner[2], p);
}

// Closed segment pq against closed triangle f in the plane of f: no axis of the separating axis
// theorem (the normals of the three sides and of the segment) parts them.
bool coplanar_segment_meets(const Facet& f, Vec3 p, Vec3 q) {
  const std::array<Vec3, 2> segment = {p, q};
  if (parted_by_side(f, 0, segment)) return false;
  const int a = orient2d(p, q, f.corner[0], f.axis);
  return a == 0 || orient2d(p, q, f.corner[1], f.axis) != a ||
         orient2d(p, q, f.corner[2], f.axis) != a;
}

bool coplanar_point_meets(const Facet& f, Vec3 p) {
  return !parted_by_side(f, 0, {&p, 1});
}

// Closed segment pq against closed triangle f; p_side and q_side are plane_side of p and q.
bool segment_meets(const Facet& f, Vec3 p, Vec3 q, int p_side, int q_side) {
  if (p_side == 0 && q_side == 0) return coplanar_segment_meets(f, p, q);
  if (p_side == q_side) return false;
  if (p_side == 0) return coplanar_point_meets(f, p);
  if (q_side == 0) return coplanar_point_meets(f, q);
  int left = 0, right = 0;  // sides of f that the line passes on either hand
  for (std::size_t i = 0; i < 3; ++i) {
    const int sign = orient3d(p, q, f.corner[i], f.corner[(i + 1) % 3]);
    left += sign > 0;
    right += sign < 0;
  }
  return left == 0 || right == 0;
}

// Turns f so that the corners shared with g come first; returns how many there are.
std::size_t shared_first(Facet& f, const Facet& g) {
  std::array<bool, 3> in_g;
  for (std::size_t i = 0; i < 3; ++i)
    in_g[i] = f.index[i] == g.index[0] || f.index[i] == g.index[1] || f.index[i] == g.index[2];
  const std::size_t shared = std::size_t{in_g[0]} + std::size_t{in_g[1]} + std::size_t{in_g[2]};
  if (shared == 0 || shared == 3) return shared;
  std::size_t first = 0;  // the lone shared corner, or the one after the lone other
  while (in_g[first] != (shared == 1)) ++first;
  if (shared == 2) first = (first + 1) % 3;
  const auto rotate = [first](auto& a) { a = {a[first], a[(first + 1) % 3], a[(first + 2) % 3]}; };
  rotate(f.index);
  rotate(f.corner);
  return shared;
}

// Plane sides of the corners of g from `shared` on; true if all are strictly on one side of f.
bool clear_of_plane(const Facet& f, const Facet& g, std::size_t shared, std::array<int, 3>& side) {
  bool clear = true;
  for (std::size_t i = shared; i < 3; ++i) {
    side[i] = plane_side(f, g.corner[i]);
    clear &= side[i] != 0 && side[i] == side[shared];
  }
  return clear;
}

// The sides of g that can meet f outside the shared corner first: all, or the opposite one.
bool some_side_meets(const Facet& f, const Facet& g, std::size_t shared,
                     const std::array<int, 3>& side) {
  for (std::size_t s = shared == 0 ? 0 : 2; s < 3; ++s) {
    const auto [i, j] = sides[s];
    if (segment_meets(f, g.corner[i], g.corner[j], side[i], side[j])) return true;
  }
  return false;
}

}  // namespace

Facet make_facet(std::span<const Vec3> points, const Triangle& triangle) {
  Facet f;
  f.index = triangle;
  f.corner = {points[triangle[0]], points[triangle[1]], points[triangle[2]]};
  const Vec3 u = f.corner[1] - f.corner[0], v = f.corner[2] - f.corner[0];
  f.normal = cross(u, v);
  f.permanent = {std::abs(u.y * v.z) + std::abs(u.z * v.y),
                 std::abs(u.z * v.x) + std::abs(u.x * v.z),
                 std::abs(u.x * v.y) + std::abs(u.y * v.x)};
  const double x = std::abs(f.normal.x), y = std::abs(f.normal.y), z = std::abs(f.normal.z);
  // The best axis by rounded arithmetic; should it be no good, one of the others is.
  f.axis = x > y && x > z ? 0 : y > z ? 1 : 2;
  for (int tries = 0; tries < 3; ++tries) {
    f.turn = orient2d(f.corner[0], f.corner[1], f.corner[2], f.axis);
    if (f.turn != 0) break;
    f.axis = (f.axis + 1) % 3;
  }
  return f;
}

// If triangles that share at most one corner meet elsewhere, then a side of one meets the other:
// walk inside the intersection, away from the shared corner, until leaving one of them.
bool facets_meet(const Facet& a, const Facet& b) {
  Facet f = a, g = b;
  const std::size_t shared = shared_first(f, g);
  if (shared == 3) return true;
  shared_first(g, f);
  const std::span<const Vec3> f_rest(f.corner.data() + shared, 3 - shared);
  const std::span<const Vec3> g_rest(g.corner.data() + shared, 3 - shared);
  if (certainly_clear(f, g_rest) || certainly_clear(g, f_rest)) return false;
  // Where the surface is nearly flat, a line parts them, and its plane would need exact arithmetic.
  if (parted_by_side(f, shared, g_rest)) return false;
  if (shared == 2) return plane_side(f, g.corner[2]) == 0;  // coplanar: then the sides decided
  if (parted_by_side(g, shared, f_rest)) return false;

  std::array<int, 3> f_side{}, g_side{};
  if (clear_of_plane(f, g, shared, g_side) || clear_of_plane(g, f, shared, f_side)) return false;
  return some_side_meets(f, g, shared, g_side) || some_side_meets(g, f, shared, f_side);
}

}  // namespace arris
