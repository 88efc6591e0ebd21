#include "feature/local_surface.h"

#include <cmath>

namespace arris {

LocalSurface tangent_plane(Vec3 origin, Vec3 n) noexcept {
  LocalSurface s;
  s.origin = origin;
  s.n = n;
  const Vec3 axis = std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  s.u = normalized(cross(n, axis));
  s.v = cross(n, s.u);
  return s;
}

}  // namespace arris
