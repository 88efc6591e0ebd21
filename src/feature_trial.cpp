#include "feature_trial.h"

#include <algorithm>
#include <iterator>

#include "base/triangle.h"
#include "base/vec.h"
#include "cloud/nearest.h"
#include "feature/facets.h"
#include "surface/handles.h"

namespace arris {
namespace {

// Times that points at handles are refused. All of a changed region would be too many: edges that
// run into each other are one.
constexpr int most_attempts = 3;
// Points nearer than this to the end of a far join are refused, in units of spacing; each time
// twice as far.
constexpr double withdrawal = 2;

// All facets at point v lie along one of the planes that were carried on to it.
bool follows(const FacetMesh& facets, Index v, const FeaturePoint& point) {
  constexpr double along = 0.97;  // cosine; planes that meet do so at 25 degrees and more
  const auto star = facets.star(v);
  return !star.empty() && std::all_of(star.begin(), star.end(), [&](Index f) {
    return std::any_of(point.surfaces.begin(), point.surfaces.end(), [&](const LocalSurface& s) {
      return dot(s.normal(point.position), facets.normal[f]) > along;
    });
  });
}

// Returns whether it refused any.
bool refuse_across_gaps(const FeatureTrial& trial, RefusedFeatures& refused) {
  const auto is_across = [](const FeaturePoint& p) { return p.gap > 0; };
  const auto& features = trial.features;
  if (std::none_of(features.begin(), features.end(), is_across)) return false;
  const std::size_t points = trial.points.size();
  if (topology_of(trial.before, points).euler == topology_of(trial.after, points).euler)
    return false;
  const std::size_t known = refused.across.size();
  if (known == 0) {
    const FacetMesh facets(trial.after, trial.points, 1);
    for (std::size_t k = 0; k < features.size(); ++k)
      if (is_across(features[k]) &&
          !follows(facets, static_cast<Index>(trial.first() + k), features[k]))
        refused.across.push_back(features[k]);
  }
  if (refused.across.size() == known)
    std::copy_if(features.begin(), features.end(), std::back_inserter(refused.across), is_across);
  return refused.across.size() > known;
}

// 1 at the points of regions where the surface got a handle; empty if there is none.
std::vector<std::uint8_t> at_new_handles(const FeatureTrial& trial) {
  const ChangedRegions regions = changed_regions(trial.before, trial.after, trial.points.size());
  const auto has_more = [&](Index r) { return r != no_index && regions.handles[r] > 0; };
  if (std::none_of(regions.of.begin(), regions.of.end(), has_more)) return {};
  std::vector<std::uint8_t> at(trial.points.size());
  std::transform(regions.of.begin(), regions.of.end(), at.begin(), has_more);
  return at;
}

// The ends, of those marked, of sides that join what lay three rings apart or more.
std::vector<Vec3> far_joins(const FeatureTrial& trial, const std::vector<std::uint8_t>& marked) {
  const FacetMesh former(trial.before, trial.points, 1);
  const std::size_t first = trial.first();
  const auto place = [&](Index v) { return v < first ? v : trial.features[v - first].near; };
  std::vector<Vec3> ends;
  SmallSet seen;
  std::vector<Index> near;
  for (const Triangle& t : trial.after)
    for (Index v : t) {  // both ways along each side
      const Index w = next_corner(t, v), a = place(v), b = place(w);
      if (!marked[v] || !marked[w] || a == b) continue;
      if (former.star(a).empty() || former.star(b).empty()) continue;
      two_rings(former, a, seen, near);
      if (!std::binary_search(near.begin(), near.end(), b)) ends.push_back(trial.points[v]);
    }
  return ends;
}

// Refuses the new points among those marked that are near one of the places. Returns whether there
// were any.
bool refuse_near(const FeatureTrial& trial, const std::vector<Vec3>& places,
                 const std::vector<std::uint8_t>& marked, double radius, RefusedFeatures& refused) {
  if (places.empty()) return false;
  const NearestSample nearest(places);
  const std::size_t known = refused.at_handles.size();
  for (std::size_t v = trial.first(); v < marked.size(); ++v)
    if (marked[v] && nearest(trial.points[v]).distance < radius * trial.spacing[v])
      refused.at_handles.push_back(trial.points[v]);
  std::sort(refused.at_handles.begin(), refused.at_handles.end(), lexicographic_less);
  return refused.at_handles.size() > known;
}

// Returns whether it refused any.
bool refuse_at_handles(const FeatureTrial& trial, RefusedFeatures& refused) {
  if (refused.attempts == most_attempts) return false;
  const std::vector<std::uint8_t> at = at_new_handles(trial);
  if (at.empty()) return false;
  const double radius = withdrawal * (1 << refused.attempts++);
  return refuse_near(trial, far_joins(trial, at), at, radius, refused);
}

}  // namespace

bool refuse_features(const FeatureTrial& trial, RefusedFeatures& refused) {
  return refuse_across_gaps(trial, refused) || refuse_at_handles(trial, refused);
}

}  // namespace arris
