#include "feature/council.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"

namespace arris {
namespace {

constexpr int least_support = 3;

}  // namespace

const Council::Agreement Council::tight = {on_surface, radians(2)};
const Council::Agreement Council::loose = {0.05, radians(8)};

void add_distinct(const LocalSurface& s, Vec3 p, std::vector<LocalSurface>& sides) {
  static const double crease = std::cos(radians(least_crease_degrees));
  const Vec3 n = s.normal(p);
  if (std::all_of(sides.begin(), sides.end(),
                  [&](const LocalSurface& o) { return dot(o.normal(p), n) < crease; }))
    sides.push_back(s);
}

// Those near v that pass through it.
void Council::listen(Index v, double far) {
  voices_.clear();
  for (Index w : near_)
    for (const LocalSurface& s : found_[w])
      if (std::abs(s.distance(points_[v])) <= far) voices_.push_back({w, &s, s.normal(points_[v])});
}

void Council::propose(Index v, const Agreement& agreement, bool own_only) {
  const double far = agreement.distance * spacing_[v] + 2 * roughness_;
  const double cosine = std::cos(agreement.angle + 2 * roughness_ / spacing_[v]);
  const double on = on_surface_distance(spacing_[v], roughness_);
  listen(v, far);
  proposals_.clear();
  for (const LocalSurface& s : found_[v])
    if (std::abs(s.distance(points_[v])) <= on)
      proposals_.push_back({&s, support(s, s.normal(points_[v]), far, cosine)});
  if (own_only) return;
  for (const Voice& o : voices_)
    if (std::abs(o.surface->distance(points_[v])) <= on)
      proposals_.push_back({o.surface, support(*o.surface, o.normal, far, cosine)});
}

// The points that have found a surface like s, which has that normal at v.
int Council::support(const LocalSurface& s, Vec3 normal, double far, double cosine) const {
  int count = 0;
  Index last = no_index;
  for (const Voice& o : voices_) {
    if (o.point == last || dot(o.normal, normal) < cosine) continue;
    if (std::abs(s.distance(points_[o.point])) > far) continue;
    last = o.point;  // counts once
    ++count;
  }
  return count;
}

void Council::settle(Index v, std::vector<LocalSurface>& out) {
  two_rings(mesh_, v, near_);
  for (bool loosely : {false, true}) {
    propose(v, loosely ? loose : tight, loosely);
    std::stable_sort(proposals_.begin(), proposals_.end(),
                     [](const Proposal& a, const Proposal& b) {
                       return a.support > b.support;  // the own ones come first among equals
                     });
    for (const Proposal& p : proposals_) {
      if (p.support < least_support) break;
      add_distinct(*p.surface, points_[v], out);
    }
    if (!out.empty()) return;
  }
}

}  // namespace arris
