#include "feature/patch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "base/angle.h"
#include "feature/fit.h"

namespace arris {
namespace {

// Enough for a quadric with room for outliers, few enough that a patch stays local.
constexpr std::size_t most_members = 28;
constexpr std::size_t quadric_members = 8;
constexpr std::size_t large_members = 9;
// Patches end at this distance from their centre, in units of spacing.
constexpr double reach = 3.5;
// Width of the Gaussian by which the weight of a member falls off, in units of spacing.
constexpr double fit_width = 1.5;
// Least sector of the star of the centre, radians, that a patch must cover: facets across a bevel
// cover less.
constexpr double least_sector = radians(50);

// The fit is renewed at growing intervals.
bool is_due(std::size_t members) {
  constexpr std::size_t due[] = {4, 6, 8, 10, 14, 20};
  return std::find(std::begin(due), std::end(due), members) != std::end(due);
}

}  // namespace

Vec3 PatchGrower::middle(Index f) const {
  const Triangle& t = mesh_.facets[f];
  return 1.0 / 3 * (points_[t[0]] + points_[t[1]] + points_[t[2]]);
}

void PatchGrower::push(Index facet, double distance) {
  frontier_.emplace_back(distance, facet);
  std::push_heap(frontier_.begin(), frontier_.end(), std::greater<>());
}

Index PatchGrower::pop() {
  std::pop_heap(frontier_.begin(), frontier_.end(), std::greater<>());
  const Index nearest = frontier_.back().second;
  frontier_.pop_back();
  return nearest;
}

bool PatchGrower::accepts(const Patch& patch, Index f, const Limits& limits) const {
  const double h = spacing_[patch.members[0]];
  const bool quadric = patch.members.size() >= quadric_members;
  for (Index v : mesh_.facets[f]) {
    const Vec3 p = points_[v];
    const double far = distance(p, patch.surface.origin);
    if (far > reach * h) return false;
    const double lever = quadric ? h / 4 : std::max(h, far) / 2;
    if (std::abs(patch.surface.distance(p)) > limits.tangent * lever + 2 * roughness_) return false;
  }
  const Vec3 n = mesh_.normal[f];
  if (n == Vec3{}) return true;
  return dot(n, patch.surface.normal(middle(f))) >=
         (quadric ? limits.quadric_cosine : limits.plane_cosine);
}

// Returns whether a point came with it.
bool PatchGrower::add_facet(Patch& patch, Index f) {
  patch.facets.push_back(f);
  const std::size_t before = patch.members.size();
  for (Index v : mesh_.facets[f]) {
    if (!members_.insert(v)) continue;
    const double d = distance(points_[v], patch.surface.origin) / spacing_[patch.members[0]];
    patch.members.push_back(v);
    patch.weight.push_back(std::exp(-d * d / (2 * fit_width * fit_width)));
  }
  return patch.members.size() > before;
}

Patch PatchGrower::grow(Index centre, Index seed, const PatchTolerance& tolerance) {
  Patch patch;
  patch.members.reserve(most_members + 2);
  patch.weight.reserve(most_members + 2);
  patch.members.push_back(centre);
  patch.weight.push_back(1);
  if (mesh_.normal[seed] == Vec3{}) return patch;
  patch.surface = tangent_plane(points_[centre], mesh_.normal[seed]);
  const FitData data{points_, patch.members, patch.weight, spacing_[centre], roughness_};
  const double rough = 2 * roughness_ / spacing_[centre];
  const Limits limits{std::cos(2 * tolerance.angle + rough), std::cos(tolerance.angle + rough),
                      tolerance.tangent};
  members_.clear();
  members_.insert(centre);
  seen_.clear();
  seen_.insert(seed);
  frontier_.clear();
  push(seed, 0);
  while (!frontier_.empty() && patch.members.size() < most_members) {
    const Index f = pop();
    if (f != seed && !accepts(patch, f, limits)) continue;
    if (add_facet(patch, f) && is_due(patch.members.size()))
      fit(data, patch.members.size() >= quadric_members ? Form::quadric : Form::plane,
          patch.surface);
    for (Index g : mesh_.neighbours[f])
      if (seen_.insert(g)) push(g, distance(middle(g), points_[centre]));
  }
  if (patch.members.size() >= large_members) fit_robustly(data, patch.surface);
  return patch;
}

bool PatchGrower::is_large(const Patch& patch) const {
  if (patch.members.size() < large_members) return false;
  const Index centre = patch.members[0];
  double sector = 0;
  for (Index f : patch.facets) {
    const Triangle& t = mesh_.facets[f];
    if (std::find(t.begin(), t.end(), centre) != t.end()) sector += angle_at(points_, t, centre);
  }
  return sector >= least_sector;
}

}  // namespace arris
