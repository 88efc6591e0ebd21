#include "feature/patch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <queue>

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
constexpr double least_sector = 50 * std::numbers::pi / 180;

bool contains(const std::vector<Index>& list, Index i) {
  return std::find(list.begin(), list.end(), i) != list.end();
}

// The fit is renewed at growing intervals.
bool is_due(std::size_t members) {
  constexpr std::size_t due[] = {4, 6, 8, 10, 14, 20};
  return std::find(std::begin(due), std::end(due), members) != std::end(due);
}

}  // namespace

PatchTolerance::PatchTolerance(double radians)
    : tangent(std::tan(radians)), cosine(std::cos(radians)), cosine_twice(std::cos(2 * radians)) {}

Vec3 PatchGrower::middle(Index f) const {
  const Triangle& t = mesh_.facets[f];
  return 1.0 / 3 * (points_[t[0]] + points_[t[1]] + points_[t[2]]);
}

bool PatchGrower::accepts(const Patch& patch, Index f, const PatchTolerance& tolerance) const {
  const double h = spacing_[patch.members[0]];
  const bool quadric = patch.members.size() >= quadric_members;
  for (Index v : mesh_.facets[f]) {
    const Vec3 p = points_[v];
    const double far = distance(p, patch.surface.origin);
    if (far > reach * h) return false;
    const double lever = quadric ? h / 4 : std::max(h, far) / 2;
    if (std::abs(patch.surface.distance(p)) > tolerance.tangent * lever) return false;
  }
  const Vec3 n = mesh_.normal[f];
  if (n == Vec3{}) return true;
  const double least = quadric ? tolerance.cosine : tolerance.cosine_twice;
  return dot(n, patch.surface.normal(middle(f))) >= least;
}

// Returns whether a point came with it.
bool PatchGrower::add_facet(Patch& patch, Index f) const {
  patch.facets.push_back(f);
  const std::size_t before = patch.members.size();
  for (Index v : mesh_.facets[f]) {
    if (contains(patch.members, v)) continue;
    const double d = distance(points_[v], patch.surface.origin) / spacing_[patch.members[0]];
    patch.members.push_back(v);
    patch.weight.push_back(std::exp(-d * d / (2 * fit_width * fit_width)));
  }
  return patch.members.size() > before;
}

Patch PatchGrower::grow(Index centre, Index seed, const PatchTolerance& tolerance) const {
  Patch patch;
  patch.members.push_back(centre);
  patch.weight.push_back(1);
  if (mesh_.normal[seed] == Vec3{}) return patch;
  patch.surface = tangent_plane(points_[centre], mesh_.normal[seed]);
  const FitData data{points_, patch.members, patch.weight, spacing_[centre]};
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> frontier;
  std::vector<Index> seen{seed};
  frontier.emplace(0, seed);
  while (!frontier.empty() && patch.members.size() < most_members) {
    const Index f = frontier.top().second;
    frontier.pop();
    if (f != seed && !accepts(patch, f, tolerance)) continue;
    if (add_facet(patch, f) && is_due(patch.members.size()))
      fit(data, patch.members.size() >= quadric_members ? Form::quadric : Form::plane,
          patch.surface);
    for (Index g : mesh_.neighbours[f]) {
      if (contains(seen, g)) continue;
      seen.push_back(g);
      frontier.emplace(distance(middle(g), points_[centre]), g);
    }
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
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] != centre) continue;
      const Vec3 a = points_[t[(i + 1) % 3]] - points_[centre];
      const Vec3 b = points_[t[(i + 2) % 3]] - points_[centre];
      sector += std::atan2(length(cross(a, b)), dot(a, b));
    }
  }
  return sector >= least_sector;
}

}  // namespace arris
