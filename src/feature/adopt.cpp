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

// The planes at the points `near` that differ at p, nearest first.
std::vector<LocalSurface> planes_round(const std::vector<Index>& near, Vec3 p,
                                       const std::vector<std::vector<LocalSurface>>& surfaces) {
  std::vector<std::pair<double, const LocalSurface*>> by_distance;
  for (Index w : near)
    for (const LocalSurface& s : surfaces[w])
      if (s.is_plane()) by_distance.emplace_back(std::abs(s.distance(p)), &s);
  std::stable_sort(by_distance.begin(), by_distance.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<LocalSurface> distinct;
  for (const auto& [distance, s] : by_distance) add_distinct(*s, p, distinct);
  return distinct;
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
      std::vector<LocalSurface> planes = planes_round(near(v), points[v], surfaces);
      const double tried = static_cast<double>(planes.size());
      std::erase_if(planes, [&](const LocalSurface& s) {
        const double off = std::abs(s.distance(points[v])) / spacing[v];
        return tried * 2 * (off + rounding) > most_false_alarms;
      });
      if (!planes.empty()) adopted.emplace_back(v, std::move(planes));
    }
    if (adopted.empty()) return;
    for (auto& [v, planes] : adopted) surfaces[v] = std::move(planes);
  }
}

}  // namespace arris
