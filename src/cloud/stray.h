// What makes a point a stray, whatever holds its neighbours: `Near` has point(p), reach(p), of(p)
// and flatness_at(q, without) as Neighbours has.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/vec.h"
#include "cloud/neighbours.h"

namespace arris {

// The reach of a stray against the median of its neighbours'. On clean clouds the largest were 1.6
// (blue noise), 1.9 (graded ten to one), 2.3 (uniformly random), 2.0 (scans).
inline constexpr double sparse_ratio = 2;

// Beyond this ratio a point is a stray even where it continues the surface, unless at neighbours
// that are as thin.
inline constexpr double far_ratio = 4;

// A point continues the surface at a neighbour if the neighbour's patch is flat (variances) and its
// plane passes the point at less than this sine.
inline constexpr double flat_enough = 0.1, in_plane_sine = 0.25;

// The median of the reaches of the neighbours of p: so many are smaller.
inline constexpr std::size_t company_rank = Neighbours::count / 2;
template <class Near>
double reach_of_company(const Near& near, Index p) {
  std::array<double, Neighbours::count> reach;
  const auto& company = near.of(p);
  for (std::size_t j = 0; j < reach.size(); ++j) reach[j] = near.reach(company[j]);
  const auto middle = reach.begin() + company_rank;
  std::nth_element(reach.begin(), middle, reach.end());
  return *middle;
}

template <class Near>
bool continues_surface_at(const Near& near, Index q, Index p) {
  const Vec3 d = near.point(p) - near.point(q);
  const Flatness f = near.flatness_at(q, p);
  return f.least <= flat_enough * f.middle &&
         std::abs(dot(d, f.normal)) <= in_plane_sine * length(d);
}

template <class Near>
bool continues_surface(const Near& near, Index p) {
  const auto& company = near.of(p);
  return std::any_of(company.begin(), company.end(),
                     [&](Index q) { return continues_surface_at(near, q, p); });
}

// A point is a sample, however dense its company is, if it continues the surface at so many
// neighbours that are as thin as it: a dense clump beside a surface makes no stray of that.
inline constexpr std::ptrdiff_t enough_alike = 4;
template <class Near>
bool has_thin_surface(const Near& near, Index p) {
  const auto& company = near.of(p);
  return std::count_if(company.begin(), company.end(), [&](Index q) {
           return near.reach(q) * sparse_ratio >= near.reach(p) && continues_surface_at(near, q, p);
         }) >= enough_alike;
}

// `expected`: the reach that its company leads one to expect.
template <class Near>
bool is_stray(const Near& near, Index p, double expected) {
  const double ratio = near.reach(p) / expected;
  if (ratio <= sparse_ratio) return false;
  return ratio > far_ratio ? !has_thin_surface(near, p) : !continues_surface(near, p);
}

}  // namespace arris
