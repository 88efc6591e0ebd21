#include "feature/meet.h"

#include <cmath>

namespace arris {
namespace {

// Newton's method doubles the digits with each step, and the surfaces are nearly planes.
constexpr int newton_steps = 6;
// After those, the surfaces are met to this share of the way from where they are centred, or never.
constexpr double largest_residual = 1e-6;
// Least volume of three unit normals: below it they have a common direction, and no corner.
constexpr double least_volume = 0.05;

bool is_on(const LocalSurface& s, Vec3 x, Vec3 start) {
  return std::abs(s.distance(x)) <= largest_residual * (distance(x, s.origin) + distance(x, start) +
                                                        distance(start, s.origin));
}

}  // namespace

std::optional<Vec3> meet(const LocalSurface& a, const LocalSurface& b, Vec3 start,
                         double least_sine) {
  Vec3 x = start;
  for (int step = 0; step < newton_steps; ++step) {
    const Vec3 na = a.normal(x), nb = b.normal(x);
    const Vec3 t = cross(na, nb);
    const double d = squared_length(t);
    if (d < least_sine * least_sine) return std::nullopt;
    const double ra = -a.distance(x), rb = -b.distance(x), rt = dot(t, start - x);
    x = x + (1 / d) * (ra * cross(nb, t) + rb * cross(t, na) + rt * t);
  }
  if (!is_on(a, x, start) || !is_on(b, x, start)) return std::nullopt;
  return x;
}

std::optional<Vec3> meet(const LocalSurface& a, const LocalSurface& b, const LocalSurface& c,
                         Vec3 start) {
  Vec3 x = start;
  for (int step = 0; step < newton_steps; ++step) {
    const Vec3 na = a.normal(x), nb = b.normal(x), nc = c.normal(x);
    const double det = dot(na, cross(nb, nc));
    if (std::abs(det) < least_volume) return std::nullopt;
    const double ra = -a.distance(x), rb = -b.distance(x), rc = -c.distance(x);
    x = x + (1 / det) * (ra * cross(nb, nc) + rb * cross(nc, na) + rc * cross(na, nb));
  }
  if (!is_on(a, x, start) || !is_on(b, x, start) || !is_on(c, x, start)) return std::nullopt;
  return x;
}

}  // namespace arris
