#include "feature/insert.h"

#include <algorithm>

#include "cloud/nearest.h"
#include "feature/point_grid.h"
#include "feature/protect.h"

namespace arris {
namespace {

// Least distance between feature points, in units of spacing. 0.6 leaves gaps that concave corners
// fall into, below 0.3 there are only more triangles.
constexpr double apart = 0.4;
// A sample this near, in units of spacing, lies on the feature already.
constexpr double occupied = 0.01;

void thin(const std::vector<Candidate>& candidates, const NearestSample& nearest, PointGrid& grid,
          std::vector<FeaturePoint>& features) {
  for (const Candidate& c : candidates) {
    const FeaturePoint& p = c.point;
    bool free = true;
    grid.visit(p.position, apart * p.spacing, [&](Index i) {
      free = distance(features[i].position, p.position) >= apart * p.spacing;
      return free;
    });
    if (!free || nearest(p.position).distance < occupied * p.spacing) continue;
    grid.add(p.position, static_cast<Index>(features.size()));
    features.push_back(p);
  }
}

// Those across gaps that others have been refused at.
void drop_refused(const std::vector<FeaturePoint>& refused, std::vector<Candidate>& candidates) {
  std::erase_if(candidates, [&](const Candidate& c) {
    return c.point.gap > 0 && std::any_of(refused.begin(), refused.end(), [&](const auto& r) {
             return distance(r.position, c.point.position) <= r.gap;
           });
  });
}

// The samples that lie on a feature themselves.
std::vector<FeaturePoint> marked_samples(const std::vector<Vec3>& points, std::size_t samples,
                                         const std::vector<double>& spacing, const Sensed& sensed) {
  std::vector<FeaturePoint> marked;
  for (Index v = 0; v < samples; ++v) {
    const auto s = sensed.at(v);
    if (s.size() > 1)
      marked.push_back({points[v], spacing[v], s.size() > 2, v, v, {s.begin(), s.end()}});
  }
  return marked;
}

}  // namespace

void insert_feature_points(const std::vector<Vec3>& points, std::size_t samples,
                           const FacetMesh& mesh, const std::vector<double>& spacing,
                           const Sensed& sensed, const std::vector<FeaturePoint>& refused,
                           std::vector<FeaturePoint>& features, Job& job) {
  const Crossing crossing{points, mesh, spacing, sensed};
  const std::vector<CrossingSide> sides = crossing_sides(crossing);
  std::vector<Candidate> corners = corner_candidates(crossing, sides, job);
  std::vector<Candidate> edges = edge_candidates(crossing, sides, job);
  drop_refused(refused, corners);
  drop_refused(refused, edges);
  const auto [least_corner, most_corner] = radii(corners, apart);
  const auto [least_edge, most_edge] = radii(edges, apart);
  const double largest = std::max(most_corner, most_edge);
  if (!(largest > 0)) return;
  const NearestSample nearest(points);
  PointGrid grid(largest, std::min(least_corner, least_edge));
  for (std::size_t i = 0; i < features.size(); ++i) {
    features[i].vertex = static_cast<Index>(samples + i);
    grid.add(features[i].position, static_cast<Index>(i));
  }
  thin(corners, nearest, grid, features);
  thin(edges, nearest, grid, features);
  protect_curves(points, nearest, mesh, marked_samples(points, samples, spacing, sensed), features,
                 job);
}

}  // namespace arris
