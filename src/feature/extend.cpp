#include "feature/extend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vec.h"
#include "seed/shapes.h"

namespace arris {
namespace {

// A corner lies on a plane within this (in units of spacing), and belongs to the gap if it is no
// farther from the point across it than this, in widths of the gap.
constexpr double on_plane = 0.1, width = 1.5;

using Across = std::vector<const FeaturePoint*>;

bool is_near_and_on(Vec3 x, const Across& across) {
  bool on = false;
  for (const FeaturePoint* p : across) {
    if (distance(x, p->position) > width * p->gap) return false;
    for (const LocalSurface& s : p->surfaces)
      on = on || std::abs(s.distance(x)) < on_plane * p->spacing;
  }
  return on;
}

// The label that a place takes from one point: inside if it is behind all convex planes, outside if
// it is before all concave ones.
Seed label_of(const FeaturePoint& p, Vec3 x) {
  if (p.turn == Turn::none) return seed_free;
  const double sign = static_cast<double>(p.turn);
  for (const LocalSurface& s : p.surfaces)
    if (sign * s.distance(x) > 0) return seed_free;
  return p.turn == Turn::convex ? seed_inside : seed_outside;
}

}  // namespace

void extend_across_gaps(const TetMesh& mesh, const std::vector<FeaturePoint>& features,
                        std::size_t known, Seeds& seeds) {
  const std::size_t first = mesh.points.size() - (features.size() - known);
  Across across;
  for (Tet t = 0; t < mesh.finite; ++t) {
    const auto& corners = mesh.vertices[t];
    across.clear();
    for (Index v : corners)
      if (v >= first && features[known + v - first].gap > 0)
        across.push_back(&features[known + v - first]);
    if (across.empty()) continue;
    seeds.firm[t] = 0;
    seeds.hint[t] = 1;
    if (!std::all_of(corners.begin(), corners.end(),
                     [&](Index v) { return is_near_and_on(mesh.points[v], across); }))
      continue;
    const Vec3 x = centroid(mesh, t);
    std::array<int, 3> votes{};
    for (const FeaturePoint* p : across) ++votes[label_of(*p, x)];
    const int in = votes[seed_inside], out = votes[seed_outside];
    if (in == 0 && out == 0) continue;
    seeds.label[t] = out == 0 ? seed_inside : in == 0 ? seed_outside : seed_free;
    seeds.hint[t] = 0;
  }
}

}  // namespace arris
