#include "feature/adopt.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "cloud/nearest.h"
#include "feature/council.h"
#include "feature/small_set.h"

namespace arris {
namespace {

// Planes that pass a sample as near would be met by chance less often than this.
constexpr double most_false_alarms = 1e-2;
// Coordinates in single precision put points off their plane by this, in units of spacing.
constexpr double rounding = 1e-5;
// Times that what was adopted is handed on; unexplained samples lie in twos and threes.
constexpr int most_rounds = 3;
// As many as there are within two rings.
constexpr std::size_t nearest_points = 19;
// Points that must know a plane. With one, half as many false points again are added round the tip
// of a faceted cone; with three, wedges have tunnels.
constexpr int least_support = 2;
// Planes that pass a sample this near, in units of spacing, are known for one; so wide that the
// planes of one face, each fitted by itself, are the same.
constexpr double same_plane = 0.005;

struct Known {
  LocalSurface plane;
  int support;
};

// The planes through p that points `near` know, nearest first.
std::vector<Known> planes_round(const std::vector<Index>& near, Vec3 p, double far,
                                const std::vector<std::vector<LocalSurface>>& surfaces) {
  std::vector<std::pair<double, const LocalSurface*>> by_distance;
  for (Index w : near)
    for (const LocalSurface& s : surfaces[w])
      if (s.is_plane() && std::abs(s.distance(p)) <= far)
        by_distance.emplace_back(std::abs(s.distance(p)), &s);
  std::stable_sort(by_distance.begin(), by_distance.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Known> known;
  for (const auto& [distance, surface] : by_distance) {
    const Vec3 n = surface->normal(p);
    const auto same = std::find_if(known.begin(), known.end(),
                                   [&](const Known& k) { return is_same_side(k.plane, n, p); });
    if (same == known.end())
      known.push_back({*surface, 1});
    else
      ++same->support;
  }
  return known;
}

// The points that may know v's planes: within two rings or, where the surface passes v by, the
// nearest ones.
class Neighbourhood {
 public:
  Neighbourhood(const std::vector<Vec3>& points, const FacetMesh& mesh)
      : points_(points), mesh_(mesh) {}

  const std::vector<Index>& operator()(Index v) {
    if (!mesh_.star(v).empty()) {
      two_rings(mesh_, v, seen_, near_);
      return near_;
    }
    if (!nearest_) nearest_.emplace(points_);
    nearest_->nearest(points_[v], nearest_points, hits_);
    near_.clear();
    for (const auto& hit : hits_) near_.push_back(hit.index);
    return near_;
  }

 private:
  const std::vector<Vec3>& points_;
  const FacetMesh& mesh_;
  std::optional<NearestSample> nearest_;  // rarely needed
  std::vector<NearestSample::Hit> hits_;
  SmallSet seen_;
  std::vector<Index> near_;
};

}  // namespace

void adopt_planes(const std::vector<Vec3>& points, const FacetMesh& mesh,
                  const std::vector<double>& spacing, const std::vector<std::uint8_t>& open,
                  std::vector<std::vector<LocalSurface>>& surfaces) {
  Neighbourhood near(points, mesh);
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<std::pair<Index, std::vector<LocalSurface>>> adopted;
    for (Index v = 0; v < open.size(); ++v) {
      if (!open[v] || !surfaces[v].empty()) continue;
      const double h = spacing[v];
      std::vector<LocalSurface> planes;
      const auto known = planes_round(near(v), points[v], same_plane * h, surfaces);
      for (const Known& k : known) {
        const double off = std::abs(k.plane.distance(points[v])) / h;
        const double alarms = static_cast<double>(known.size()) * 2 * (off + rounding);
        if (k.support >= least_support && alarms <= most_false_alarms) planes.push_back(k.plane);
      }
      if (!planes.empty()) adopted.emplace_back(v, std::move(planes));
    }
    if (adopted.empty()) return;
    for (auto& [v, planes] : adopted) surfaces[v] = std::move(planes);
  }
}

}  // namespace arris
