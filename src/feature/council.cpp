#include "feature/council.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"

namespace arris {
namespace {

constexpr int least_support = 3;

// The nearest points that are heard: within two rings there are 20 to 100, but thousands round the
// tip of a cone.
constexpr std::size_t most_near = 4 * most_round;

}  // namespace

const Council::Agreement Council::tight = {on_surface, radians(2)};
const Council::Agreement Council::loose = {0.05, radians(8)};

bool is_same_side(const LocalSurface& s, Vec3 normal, Vec3 p) {
  static const double crease = std::cos(radians(least_crease_degrees));
  return s.has_direction(p, normal, crease);
}

void add_distinct(const LocalSurface& s, Vec3 p, std::vector<LocalSurface>& sides) {
  const Vec3 n = s.normal(p);
  if (std::none_of(sides.begin(), sides.end(),
                   [&](const LocalSurface& o) { return is_same_side(o, n, p); }))
    sides.push_back(s);
}

// Those near v that pass through it.
void Council::listen(Index v, double far) {
  voices_.clear();
  for (Index w : near_)
    for (const LocalSurface& s : found_[w])
      if (s.is_within(points_[v], far)) voices_.push_back({w, &s, s.normal(points_[v])});
}

void Council::propose(Index v, const Agreement& agreement, bool own_only) {
  const double far = agreement.distance * spacing_[v] + 2 * roughness_;
  const double cosine = std::cos(agreement.angle + 2 * roughness_ / spacing_[v]);
  const double on = on_surface_distance(spacing_[v], roughness_);
  listen(v, far);
  proposals_.clear();
  for (const LocalSurface& s : found_[v])
    if (s.is_within(points_[v], on))
      proposals_.push_back({&s, support(s, s.normal(points_[v]), far, cosine)});
  if (own_only) return;
  const LocalSurface* agreed = agreed_by_all();
  for (const Voice& o : voices_)
    if (o.surface->is_within(points_[v], on) &&
        !(agreed && is_same_side(*agreed, o.normal, points_[v])))
      proposals_.push_back({o.surface, support(*o.surface, o.normal, far, cosine)});
}

// The first proposal, if none can have more support: others of that side need no count.
const LocalSurface* Council::agreed_by_all() const {
  if (proposals_.empty()) return nullptr;
  int points = 0;
  for (std::size_t k = 0; k < voices_.size(); ++k)
    points += k == 0 || voices_[k].point != voices_[k - 1].point;
  return proposals_[0].support == points ? proposals_[0].surface : nullptr;
}

// The points that have found a surface like s, which has that normal at v.
int Council::support(const LocalSurface& s, Vec3 normal, double far, double cosine) const {
  int count = 0;
  Index last = no_index;
  for (const Voice& o : voices_) {
    if (o.point == last || dot(o.normal, normal) < cosine) continue;
    if (!s.is_within(points_[o.point], far)) continue;
    last = o.point;  // counts once
    ++count;
  }
  return count;
}

void Council::settle(Index v, std::vector<LocalSurface>& out) {
  two_rings(mesh_, v, seen_, near_);
  keep_nearest(points_, v, most_near, near_);
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
