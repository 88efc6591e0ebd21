#include "cloud/clumps.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/vec.h"

namespace arris {
namespace {

// A group that is this many times smaller than the model may be a clump.
constexpr std::size_t minor = 3;

// Fewer points bound no solid that a model of `minor_solid` times as many could want.
constexpr std::size_t fewest = 6, minor_solid = 20;

// A group of less than `thin_count` points whose reach is `thin` times that of the model: strays
// that found each other. A part of the model would be sampled better.
constexpr std::size_t thin_count = 60;
constexpr double thin = 3;

// Points that fill space: mean of (least / middle variance) over patches, and the share of points
// without a free side. Balls and normal clumps of 50 points or more have at least 0.31 and 0.20,
// of 100 points 0.35 and 0.33; blue samples of a sphere, cube, octahedron, cone, thin plate,
// L-bracket and torus of 50 to 200 points at most one of the two.
constexpr double filling_flatness = 0.3, filling_enclosed = 0.2;

// With fewer points a solid fills as much of its space as a clump does: it gets the benefit.
constexpr std::size_t smallest_clump = 40;

// The free side of a point: a ball of this many reaches that touches it and holds no neighbour.
constexpr double free_ball = 1;

class Groups {
 public:
  explicit Groups(const Neighbours& near) : near_(near), up_(near.size()) {
    std::iota(up_.begin(), up_.end(), Index{0});
    for (Index p = 0; p < near.size(); ++p) {
      if (near.gone(p)) continue;
      for (std::size_t j = 0; j < Neighbours::rank; ++j) join(p, near.of(p)[j]);
    }
    for (Index p = 0; p < near.size(); ++p) up_[p] = root(p);
  }

  // Members of every group, largest group first, equal ones by their first point.
  std::vector<std::vector<Index>> members() const {
    std::vector<std::vector<Index>> groups;
    std::vector<Index> number(near_.size(), no_index);
    for (Index p = 0; p < near_.size(); ++p) {
      if (near_.gone(p)) continue;
      Index& n = number[up_[p]];
      if (n == no_index) {
        n = static_cast<Index>(groups.size());
        groups.emplace_back();
      }
      groups[n].push_back(p);
    }
    std::stable_sort(groups.begin(), groups.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return groups;
  }

 private:
  Index root(Index p) {
    while (up_[p] != p) p = up_[p] = up_[up_[p]];
    return p;
  }
  void join(Index p, Index q) {
    if (!are_linked(distance(near_.point(p), near_.point(q)), near_.reach(p), near_.reach(q)))
      return;
    const Index a = root(p), b = root(q);
    up_[std::max(a, b)] = std::min(a, b);
  }

  const Neighbours& near_;
  std::vector<Index> up_;
};

// Whether some ball that touches p, on either side of its patch or away from its neighbours, holds
// none of them: a point of a surface has such a side, one within a clump has not.
bool has_free_side(const Neighbours& near, Index p, Vec3 normal) {
  Vec3 towards;
  for (std::size_t j = 0; j < Neighbours::patch; ++j) {
    towards = towards + normalized(near.point(near.of(p)[j]) - near.point(p));
  }
  const double l = length(towards), r = free_ball * near.reach(p);
  if (l > 0) towards = 1 / l * towards;
  for (Vec3 side : {normal, -normal, towards, -towards}) {
    const Vec3 centre = near.point(p) + r * side;
    // A hair less than r: p's own rounding, and neighbours in the plane, do not count as within.
    if (std::all_of(near.of(p).begin(), near.of(p).end(),
                    [&](Index q) { return distance(centre, near.point(q)) >= 0.999 * r; }))
      return true;
  }
  return false;
}

// What tells a clump from a part of the model.
struct Character {
  double reach = 0;  // mean
  bool fills_space = false;
};

Character character(const Neighbours& near, const std::vector<Index>& group) {
  double reach = 0, flat = 0, enclosed = 0;
  for (Index p : group) {
    const Flatness f = near.flatness_at(p);
    reach += near.reach(p);
    flat += f.middle > 0 ? f.least / f.middle : 0;
    enclosed += has_free_side(near, p, f.normal) ? 0 : 1;
  }
  const auto n = static_cast<double>(group.size());
  return {reach / n, flat > filling_flatness * n && enclosed > filling_enclosed * n};
}

bool is_clump(const Neighbours& near, const std::vector<Index>& group, std::size_t model_size,
              const Character& model) {
  if (group.size() < fewest) return group.size() * minor_solid <= model_size;
  const Character c = character(near, group);
  const bool thinner = c.reach > thin * model.reach;
  if (thinner && group.size() < thin_count) return true;
  return group.size() >= smallest_clump && c.fills_space && (thinner || !model.fills_space);
}

}  // namespace

bool are_linked(double distance, double reach_a, double reach_b) noexcept {
  constexpr double link = 2.5;  // reaches of either
  return distance <= link * std::min(reach_a, reach_b);
}

std::vector<std::uint8_t> find_clumps(const Neighbours& neighbours) {
  std::vector<std::uint8_t> clump(neighbours.size(), 0);
  const std::vector<std::vector<Index>> groups = Groups(neighbours).members();
  if (groups.size() < 2) return clump;
  const Character model = character(neighbours, groups[0]);
  for (std::size_t g = 1; g < groups.size(); ++g) {
    if (groups[g].size() * minor > groups[0].size()) continue;
    if (!is_clump(neighbours, groups[g], groups[0].size(), model)) continue;
    for (Index p : groups[g]) clump[p] = 1;
  }
  return clump;
}

}  // namespace arris
