#include "feature/council.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arris {
namespace {

double cosine_of(double degrees) {
  return std::cos(degrees * std::numbers::pi / 180);
}

constexpr int least_support = 3;

}  // namespace

const Council::Agreement Council::tight = {on_surface, cosine_of(2)};
const Council::Agreement Council::loose = {0.05, cosine_of(8)};

void Council::propose(Index v, const Agreement& agreement, bool own_only) {
  proposals_.clear();
  const auto add = [&](Index w) {
    for (const LocalSurface& s : found_[w])
      if (std::abs(s.distance(points_[v])) <= on_surface * spacing_[v])
        proposals_.push_back({&s, w == v, support(s, v, agreement)});
  };
  add(v);
  if (own_only) return;
  for (Index w : near_) add(w);
}

int Council::support(const LocalSurface& s, Index v, const Agreement& agreement) const {
  int count = 0;
  const Vec3 n = s.normal(points_[v]);
  const double far = agreement.distance * spacing_[v];
  for (Index w : near_) {
    if (found_[w].empty() || std::abs(s.distance(points_[w])) > far) continue;
    count += std::any_of(found_[w].begin(), found_[w].end(), [&](const LocalSurface& o) {
      return std::abs(o.distance(points_[v])) <= far &&
             dot(o.normal(points_[v]), n) >= agreement.cosine;
    });
  }
  return count;
}

void Council::settle(Index v, std::vector<LocalSurface>& out) {
  static const double crease = cosine_of(least_crease_degrees);
  two_rings(mesh_, v, near_);
  for (bool loosely : {false, true}) {
    propose(v, loosely ? loose : tight, loosely);
    std::stable_sort(proposals_.begin(), proposals_.end(),
                     [](const Proposal& a, const Proposal& b) {
                       return a.support > b.support;  // the own ones come first among equals
                     });
    for (const Proposal& p : proposals_) {
      if (p.support < least_support) break;
      const Vec3 n = p.surface->normal(points_[v]);
      if (std::all_of(out.begin(), out.end(),
                      [&](const LocalSurface& s) { return dot(s.normal(points_[v]), n) < crease; }))
        out.push_back(*p.surface);
    }
    if (!out.empty()) return;
  }
}

}  // namespace arris
