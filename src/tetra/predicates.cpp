#include "tetra/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>

namespace arris {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Twice Shewchuk's bound (7 + 56 eps) eps for the rounding error of the expanded determinant,
// relative to its permanent; eps = 2^-53 (Shewchuk, "Adaptive precision floating-point arithmetic
// and fast robust geometric predicates", 1997).
constexpr double orient3d_error = 2 * 7.77156117237609e-16;
constexpr double orient2d_error = 2 * 3.33066907387547e-16;
// Underflow: a product of two may be off by 2^-1075, which the third factor then multiplies, and
// the relative bound does not see it. This times (1 + third factors) covers it generously.
constexpr double smallest_safe = 1e-300;

int exact_orient2d(double ax, double ay, double bx, double by, double cx, double cy) {
  return static_cast<int>(
      CGAL::orientation(Kernel::Point_2(ax, ay), Kernel::Point_2(bx, by), Kernel::Point_2(cx, cy)));
}

}  // namespace

int orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const double ax = a.x - d.x, ay = a.y - d.y, az = a.z - d.z;
  const double bx = b.x - d.x, by = b.y - d.y, bz = b.z - d.z;
  const double cx = c.x - d.x, cy = c.y - d.y, cz = c.z - d.z;
  const double bxcy = bx * cy, cxby = cx * by, cxay = cx * ay;
  const double axcy = ax * cy, axby = ax * by, bxay = bx * ay;
  const double det = az * (bxcy - cxby) + bz * (cxay - axcy) + cz * (axby - bxay);
  const double permanent = std::abs(az) * (std::abs(bxcy) + std::abs(cxby)) +
                           std::abs(bz) * (std::abs(cxay) + std::abs(axcy)) +
                           std::abs(cz) * (std::abs(axby) + std::abs(bxay));
  const double underflow = smallest_safe * (1 + std::abs(az) + std::abs(bz) + std::abs(cz));
  const double bound = orient3d_error * permanent + underflow;
  if (std::isfinite(permanent)) {
    if (det > bound) return -1;  // Shewchuk's sign: positive when d is below abc
    if (-det > bound) return 1;
  }
  // Flat in an axis-parallel plane, the one common zero that needs no arithmetic.
  if ((ax == 0 && bx == 0 && cx == 0) || (ay == 0 && by == 0 && cy == 0) ||
      (az == 0 && bz == 0 && cz == 0))
    return 0;
  return static_cast<int>(
      CGAL::orientation(Kernel::Point_3(a.x, a.y, a.z), Kernel::Point_3(b.x, b.y, b.z),
                        Kernel::Point_3(c.x, c.y, c.z), Kernel::Point_3(d.x, d.y, d.z)));
}

int orient2d(Vec3 a, Vec3 b, Vec3 c, int axis) {
  const auto flat = [axis](Vec3 p, double& u, double& v) {
    u = axis == 0 ? p.y : axis == 1 ? p.z : p.x;
    v = axis == 0 ? p.z : axis == 1 ? p.x : p.y;
  };
  double au, av, bu, bv, cu, cv;
  flat(a, au, av);
  flat(b, bu, bv);
  flat(c, cu, cv);
  const double left = (au - cu) * (bv - cv), right = (av - cv) * (bu - cu);
  const double det = left - right, permanent = std::abs(left) + std::abs(right);
  const double bound = orient2d_error * permanent + smallest_safe;
  if (std::isfinite(permanent)) {
    if (det > bound) return 1;
    if (-det > bound) return -1;
  }
  // On a line parallel to an axis, the one common zero that needs no arithmetic.
  if ((au == cu && bu == cu) || (av == cv && bv == cv)) return 0;
  return exact_orient2d(au, av, bu, bv, cu, cv);
}

bool collinear(Vec3 a, Vec3 b, Vec3 c) {
  return orient2d(a, b, c, 0) == 0 && orient2d(a, b, c, 1) == 0 && orient2d(a, b, c, 2) == 0;
}

}  // namespace arris
