#include "surface/handles.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/distinct.h"
#include "base/triangle.h"
#include "seed/parity_forest.h"
#include "surface/extract.h"
#include "tetra/facet_stars.h"

namespace arris {
namespace {

// Points joined by the facets, as sets.
ParityForest joined_by(const std::vector<Triangle>& triangles, std::size_t points) {
  ParityForest sets(points);
  for (const Triangle& t : triangles) {
    sets.join(t[0], t[1], false);
    sets.join(t[0], t[2], false);
  }
  return sets;
}

bool same_facet(const Triangle& s, const Triangle& t) {  // if t lacks s[0], no rotation is equal
  const std::size_t i = corner_of(t, s[0]);
  return s == Triangle{t[i], t[(i + 1) % 3], t[(i + 2) % 3]};
}

// Appends the triangles that are not among the others.
void append_missing(const std::vector<Triangle>& triangles, const std::vector<Triangle>& others,
                    std::size_t points, std::vector<Triangle>& missing) {
  const FacetStars stars(points, others);
  std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(missing),
               [&](const Triangle& t) {
                 const auto star = stars[t[0]];
                 return std::none_of(star.begin(), star.end(),
                                     [&](Index f) { return same_facet(others[f], t); });
               });
}

// Per region the number of components that have a point in it.
std::vector<std::int64_t> components_met(const std::vector<Index>& region, std::size_t regions,
                                         const std::vector<Triangle>& triangles) {
  ParityForest components = joined_by(triangles, region.size());
  std::vector<std::pair<Index, Index>> met;
  for (const Triangle& t : triangles)
    for (Index v : t)
      if (region[v] != no_index) met.push_back({region[v], components.find(v).node});
  keep_distinct(met);
  std::vector<std::int64_t> count(regions, 0);
  for (const auto& [r, component] : met) ++count[r];
  return count;
}

}  // namespace

Topology topology_of(const std::vector<Triangle>& triangles, std::size_t points) {
  ParityForest sets = joined_by(triangles, points);
  const std::vector<std::uint8_t> used = corners_of(triangles, points);
  Topology topology{0, -static_cast<std::int64_t>(triangles.size() / 2)};
  for (Index v = 0; v < points; ++v) {
    topology.euler += used[v];
    topology.components += used[v] && sets.find(v).node == v;
  }
  return topology;
}

ChangedRegions changed_regions(const std::vector<Triangle>& before,
                               const std::vector<Triangle>& after, std::size_t points) {
  std::vector<Triangle> changed;
  append_missing(before, after, points, changed);
  const std::size_t gone = changed.size();
  append_missing(after, before, points, changed);
  ParityForest sets = joined_by(changed, points);
  const std::vector<std::uint8_t> touched = corners_of(changed, points);
  ChangedRegions regions{std::vector<Index>(points, no_index), {}};
  Index count = 0;
  for (Index v = 0; v < points; ++v)
    if (touched[v] && sets.find(v).node == v) regions.of[v] = count++;
  for (Index v = 0; v < points; ++v)
    if (touched[v]) regions.of[v] = regions.of[sets.find(v).node];

  // Twice the change of V - F / 2: each facet has half of three sides.
  std::vector<std::int64_t> euler(count, 0);
  const std::vector<std::uint8_t> was = corners_of(before, points), is = corners_of(after, points);
  for (std::size_t v = 0; v < points; ++v)
    if (touched[v]) euler[regions.of[v]] += 2 * (is[v] - was[v]);
  for (std::size_t f = 0; f < changed.size(); ++f)
    euler[regions.of[changed[f][0]]] += f < gone ? 1 : -1;
  if (std::all_of(euler.begin(), euler.end(), [](std::int64_t e) { return e == 0; })) {
    regions.handles.assign(count, 0);
    return regions;
  }
  const auto met_before = components_met(regions.of, count, before);
  const auto met_after = components_met(regions.of, count, after);
  for (Index r = 0; r < count; ++r)
    regions.handles.push_back(met_after[r] - met_before[r] - euler[r] / 4);
  return regions;
}

}  // namespace arris
