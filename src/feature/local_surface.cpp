#include "feature/local_surface.h"

#include <cmath>

namespace arris {
namespace {

struct Slope {
  double z, zx, zy;
};

Slope slope(const LocalSurface& s, double x, double y) {
  const auto& c = s.c;
  return {c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y,
          c[1] + 2 * c[3] * x + c[4] * y, c[2] + c[4] * x + 2 * c[5] * y};
}

}  // namespace

double LocalSurface::distance(Vec3 p) const noexcept {
  const Vec3 d = p - origin;
  const Slope s = slope(*this, dot(d, u), dot(d, v));
  return (dot(d, n) - s.z) / std::sqrt(1 + s.zx * s.zx + s.zy * s.zy);
}

Vec3 LocalSurface::normal(Vec3 p) const noexcept {
  const Vec3 d = p - origin;
  const Slope s = slope(*this, dot(d, u), dot(d, v));
  const Vec3 g = n - s.zx * u - s.zy * v;
  return (1 / length(g)) * g;
}

LocalSurface tangent_plane(Vec3 origin, Vec3 n) noexcept {
  LocalSurface s;
  s.origin = origin;
  s.n = n;
  const Vec3 axis = std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 u = cross(n, axis);
  s.u = (1 / length(u)) * u;
  s.v = cross(n, s.u);
  return s;
}

}  // namespace arris
