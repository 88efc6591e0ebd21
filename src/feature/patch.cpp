#include "feature/patch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "base/angle.h"
#include "base/triangle.h"

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

bool PatchGrower::accepts(Index f, const Limits& limits) {
  for (Index v : mesh_.facets[f])
    if (!is_near(v, limits.tangent)) return false;
  const Vec3 n = mesh_.normal[f];
  if (n == Vec3{}) return true;
  const bool quadric = patch_.members.size() >= quadric_members;
  return patch_.surface.has_direction(middle_of(points_, mesh_.facets[f]), n,
                                      quadric ? limits.quadric_cosine : limits.plane_cosine);
}

// Whether the point lies near enough to the centre and to the fit so far. Every facet round the
// point asks: the answer is kept until the fit is renewed.
bool PatchGrower::is_near(Index v, double tangent) {
  Reached& point = reached_[v];
  if (point.fit == fits_) return point.is_near;
  point.fit = fits_;
  const Vec3 p = points_[v];
  if (point.far < 0) point.far = distance(p, patch_.surface.origin);
  const double h = spacing_[patch_.members[0]];
  const bool quadric = patch_.members.size() >= quadric_members;
  const double lever = quadric ? h / 4 : std::max(h, point.far) / 2;
  point.is_near =
      point.far <= reach * h && patch_.surface.is_within(p, tangent * lever + 2 * roughness_);
  return point.is_near;
}

// Returns whether a point came with it.
bool PatchGrower::add_facet(Index f) {
  patch_.facets.push_back(f);
  const std::size_t before = patch_.members.size();
  for (Index v : mesh_.facets[f]) {
    Reached& point = reached_[v];
    if (point.is_member) continue;
    point.is_member = true;
    if (point.far < 0) point.far = distance(points_[v], patch_.surface.origin);
    const double d = point.far / spacing_[patch_.members[0]];
    patch_.members.push_back(v);
    fit_.add(points_[v], std::exp(-d * d / (2 * fit_width * fit_width)));
  }
  return patch_.members.size() > before;
}

// With `centre` alone.
void PatchGrower::start(Index centre, Index seed) {
  patch_.members.assign(1, centre);
  patch_.facets.clear();
  patch_.surface = tangent_plane(points_[centre], mesh_.normal[seed]);
  fit_.start(patch_.surface, spacing_[centre], roughness_);
  fit_.add(points_[centre], 1);
  fits_ = 0;
  reached_.clear();
  reached_[centre].is_member = true;
  seen_.clear();
  seen_.insert(seed);
  frontier_.clear();
  push(seed, 0);
}

std::optional<Patch> PatchGrower::grow(Index centre, Index seed, const PatchTolerance& tolerance) {
  if (mesh_.normal[seed] == Vec3{}) return std::nullopt;
  const double rough = 2 * roughness_ / spacing_[centre];
  const Limits limits{std::cos(2 * tolerance.angle + rough), std::cos(tolerance.angle + rough),
                      tolerance.tangent};
  start(centre, seed);
  while (!frontier_.empty() && patch_.members.size() < most_members) {
    const Index f = pop();
    if (f != seed && !accepts(f, limits)) continue;
    if (add_facet(f) && is_due(patch_.members.size())) {
      const bool quadric = patch_.members.size() >= quadric_members;
      fit_.fit(quadric ? Form::quadric : Form::plane, patch_.surface);
      ++fits_;
    }
    for (Index g : mesh_.neighbours[f])
      if (seen_.insert(g)) push(g, distance(middle_of(points_, mesh_.facets[g]), points_[centre]));
  }
  if (!is_large()) return std::nullopt;
  fit_.fit_robustly(patch_.surface);
  return patch_;
}

bool PatchGrower::is_large() const {
  if (patch_.members.size() < large_members) return false;
  const Index centre = patch_.members[0];
  double sector = 0;
  for (Index f : patch_.facets) {
    const Triangle& t = mesh_.facets[f];
    if (std::find(t.begin(), t.end(), centre) != t.end()) sector += angle_at(points_, t, centre);
  }
  return sector >= least_sector;
}

}  // namespace arris
