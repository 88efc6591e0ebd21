#include "feature/small_planes.h"

#include <algorithm>
#include <cmath>

#include "feature/fit.h"

namespace arris {
namespace {

// Fewer planes than this would be found round one sample by chance. Measured on random solids: at
// 1e-4 a few faces of four samples are lost, planes taken by chance are rare either way.
constexpr double most_false_alarms = 1e-2;
// The points looked at, nearest first: all pairs of them are tried.
constexpr std::size_t most_points = 16;
// In units of spacing: how far from the centre a member may be, and how far off the plane.
constexpr double reach = 3.5, exact = 1e-3;
// Coordinates in single precision put points off their plane by this, in units of spacing.
constexpr double rounding = 1e-5;
// Least height of the triangle that a plane is tried through, in units of spacing.
constexpr double least_height = 0.2;
// A plane that stands steeper on the facets round the centre has no side that is outside for sure.
constexpr double least_cosine = 0.2;

// The planes tried, times the probability that `members` of the `others` are as near to one as
// `far` (in units of spacing), if they were spread over one spacing across it.
double false_alarms(std::size_t others, std::size_t members, double far) {
  const double share = std::min(1.0, 2 * (far + rounding));
  double number = static_cast<double>((others + 2) * (others + 1) / 2 * others);
  for (std::size_t k = 0; k < members; ++k)
    number *= share * static_cast<double>(others - k) / static_cast<double>(k + 1);
  return number;
}

}  // namespace

void SmallPlanes::gather(Index v) {
  two_rings(mesh_, v, seen_, near_);
  const double far = reach * spacing_[v];
  std::erase_if(near_,
                [&](Index w) { return !open_[w] || distance(points_[v], points_[w]) > far; });
  std::stable_sort(near_.begin(), near_.end(), [&](Index a, Index b) {
    return distance(points_[v], points_[a]) < distance(points_[v], points_[b]);
  });
  if (near_.size() > most_points) near_.resize(most_points);
}

// Through v and the near points i and j, with as many others as make it least likely.
void SmallPlanes::try_plane(Index v, std::size_t i, std::size_t j, Plane& best) {
  const double h = spacing_[v];
  const Vec3 a = points_[near_[i]] - points_[v], b = points_[near_[j]] - points_[v];
  const Vec3 across = cross(a, b);
  const double twice_area = length(across);
  if (twice_area < least_height * h * std::max({length(a), length(b), length(a - b)})) return;
  const Vec3 normal = (1 / twice_area) * across;
  off_.clear();
  for (std::size_t k = 0; k < near_.size(); ++k)
    if (k != i && k != j)
      off_.emplace_back(std::abs(dot(normal, points_[near_[k]] - points_[v])) / h, near_[k]);
  std::sort(off_.begin(), off_.end());
  for (std::size_t m = 1; m <= off_.size() && off_[m - 1].first <= exact; ++m) {
    const double number = false_alarms(off_.size(), m, off_[m - 1].first);
    if (number >= best.false_alarms) continue;
    best = {normal, number, {v, near_[i], near_[j]}};
    for (std::size_t k = 0; k < m; ++k) best.members.push_back(off_[k].second);
  }
}

// Mean direction of the facets round v.
Vec3 SmallPlanes::outward(Index v) const {
  Vec3 sum{};
  for (Index f : mesh_.star(v)) sum = sum + angle_at(points_, mesh_.facets[f], v) * mesh_.normal[f];
  const double size = length(sum);
  return size > 0 ? (1 / size) * sum : sum;
}

void SmallPlanes::find(Index v, std::vector<LocalSurface>& out) {
  gather(v);
  Plane best{{}, most_false_alarms, {}};
  for (std::size_t i = 0; i < near_.size(); ++i)
    for (std::size_t j = i + 1; j < near_.size(); ++j) try_plane(v, i, j, best);
  if (best.members.empty()) return;
  const double cosine = dot(best.normal, outward(v));
  if (std::abs(cosine) < least_cosine) return;
  LocalSurface plane = tangent_plane(points_[v], cosine > 0 ? best.normal : -best.normal);
  PatchFit fit;
  fit.start(plane, spacing_[v], 0);
  for (Index w : best.members) fit.add(points_[w], 1);
  fit.fit(Form::plane, plane);
  out.push_back(plane);
}

}  // namespace arris
