// A quadric height field over a tangent frame: what is sensed of the surface on one side of a
// sample.
#pragma once

#include <array>
#include <cmath>

#include "arris/types.h"
#include "base/vec.h"

namespace arris {

// z = c0 + c1 x + c2 y + c3 x² + c4 xy + c5 y² in the frame (u, v, n) at `origin`.
struct LocalSurface {
  Vec3 origin;
  Vec3 u, v, n;  // orthonormal; n outward
  std::array<double, 6> c{};

  bool is_plane() const noexcept { return c[3] == 0 && c[4] == 0 && c[5] == 0; }
  // Signed distance to first order: positive outside.
  double distance(Vec3 p) const noexcept {
    const Foot f = foot(p);
    return (f.above - f.z) / std::sqrt(1 + f.zx * f.zx + f.zy * f.zy);
  }
  // Whether that distance is at most `far`: mostly the height alone, never less, tells.
  bool is_within(Vec3 p, double far) const noexcept {
    const Foot f = foot(p);
    const double height = std::abs(f.above - f.z);
    return height <= far || height / std::sqrt(1 + f.zx * f.zx + f.zy * f.zy) <= far;
  }
  // Outward unit normal at the foot of p.
  Vec3 normal(Vec3 p) const noexcept { return normalized(gradient(p)); }
  // Whether dot(normal(p), unit) is at least `cosine`: mostly told without a root.
  bool has_direction(Vec3 p, Vec3 unit, double cosine) const noexcept {
    const Vec3 g = gradient(p);
    const double gg = squared_length(g), along = dot(unit, g);
    const double excess = along * std::abs(along) - cosine * std::abs(cosine) * gg;
    constexpr double rounding = 1e-9;  // generously
    if (std::abs(excess) > rounding * gg) return excess > 0;
    return dot(unit, (1 / length(g)) * g) >= cosine;
  }

 private:
  // p over the tangent plane, and the height field with its slope there.
  struct Foot {
    double above, z, zx, zy;
  };
  Vec3 gradient(Vec3 p) const noexcept {
    const Foot f = foot(p);
    return n - f.zx * u - f.zy * v;
  }
  Foot foot(Vec3 p) const noexcept {
    const Vec3 d = p - origin;
    const double x = dot(d, u), y = dot(d, v);
    return {dot(d, n), c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y,
            c[1] + 2 * c[3] * x + c[4] * y, c[2] + c[4] * x + 2 * c[5] * y};
  }
};

// A plane through `origin` with unit normal `n`.
LocalSurface tangent_plane(Vec3 origin, Vec3 n) noexcept;

}  // namespace arris
