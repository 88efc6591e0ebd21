#include "feature/crossing.h"

#include <cmath>

#include "base/angle.h"

namespace arris {
namespace {

// Bounds of agreement: below the least angle of a crease, above what two fits on one side of a
// curved surface differ by.
const double agreeing_cosine = std::cos(radians(18));
constexpr double agreeing_distance = 0.1;  // in units of spacing
// A point this near to a plane is on neither side of it (in units of spacing).
constexpr double level = 1e-6;

}  // namespace

bool Crossing::agree(const Side& a, const Side& b) const {
  const Vec3 u = points[a.point], v = points[b.point];
  const double far = agreeing_distance * (spacing[a.point] + spacing[b.point]) / 2;
  return a.surface->is_within(v, far) && b.surface->is_within(u, far) &&
         a.surface->has_direction(v, b.surface->normal(v), agreeing_cosine);
}

bool Crossing::crosses(Index u, Index v) const {
  if (sensed.at(u).empty() || sensed.at(v).empty()) return false;
  for (const LocalSurface& a : sensed.at(u))
    for (const LocalSurface& b : sensed.at(v))
      if (agree({u, &a}, {v, &b})) return false;
  return true;
}

Turn Crossing::turn(const Side& a, const Side& b) const {
  const double far = level * spacing[a.point];
  const double bv = a.surface->distance(points[b.point]);
  const double au = b.surface->distance(points[a.point]);
  if (bv < far && au < far) return Turn::convex;
  if (bv > -far && au > -far) return Turn::concave;
  return Turn::none;
}

std::vector<CrossingSide> crossing_sides(const Crossing& crossing) {
  std::vector<CrossingSide> sides;
  for (Index f = 0; f < crossing.mesh.facets.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index u = crossing.mesh.facets[f][i], v = crossing.mesh.facets[f][(i + 1) % 3];
      if (u < v && crossing.crosses(u, v)) sides.push_back({u, v, f});
    }
  return sides;
}

}  // namespace arris
