#include "feature/protect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cloud/nearest.h"
#include "feature/meet.h"
#include "feature/point_grid.h"

namespace arris {
namespace {

// All in units of spacing. Gaps are looked for up to `reach`, split above `longest` always, above
// `shortest` if a point enters; a point nearer than `occupied` to the new one makes it needless.
constexpr double reach = 2.5;
constexpr double longest = 0.8;
constexpr double shortest = 0.3;
constexpr double occupied = 0.01;
// A curve goes on within this cosine of its direction.
constexpr double ahead = 0.9;
// Two surfaces are the same at a feature point within this cosine and distance.
constexpr double same_cosine = 0.97, same_distance = 0.1;
// New points are kept away from the ends of the gap, and near to it.
constexpr double least_share = 0.25, largest_move = 0.3;
constexpr double least_sine = 0.1;
// What enters the diametral ball itself, not its boundary.
constexpr double inside = 0.499;

class Protector {
 public:
  Protector(const std::vector<Vec3>& points, const NearestSample& nearest, const FacetMesh& mesh,
            std::vector<FeaturePoint>& all, double smallest, double largest)
      : points_(points),
        nearest_(nearest),
        mesh_(mesh),
        all_(all),
        grid_(reach * largest, occupied * smallest) {
    for (std::size_t i = 0; i < all_.size(); ++i)
      grid_.add(all_[i].position, static_cast<Index>(i));
  }

  void run(Job& job) {
    for (std::size_t i = 0; i < all_.size(); ++i) {  // grows while it runs
      if (i % 4096 == 0) job.tick(0);
      const FeaturePoint p = all_[i];
      for (std::size_t a = 0; a < p.surfaces.size(); ++a)
        for (std::size_t b = a + 1; b < p.surfaces.size(); ++b)
          split_along(p, p.surfaces[a], p.surfaces[b]);
    }
  }

 private:
  void split_along(const FeaturePoint& p, const LocalSurface& a, const LocalSurface& b) {
    const Vec3 t = cross(a.normal(p.position), b.normal(p.position));
    const double sine = length(t);
    if (sine < least_sine) return;
    for (const Index q : next_both_ways(p, a, b, (1 / sine) * t))
      if (q != no_index) split(p, FeaturePoint(all_[q]), a, b);
  }

  void split(const FeaturePoint& p, const FeaturePoint& q, const LocalSurface& a,
             const LocalSurface& b) {
    if (is_side(p.vertex, q.vertex)) return;
    const Vec3 along = q.position - p.position;
    const double gap = length(along), h = std::min(p.spacing, q.spacing);
    const NearestSample::Hit hit = nearest_(p.position + 0.5 * along);
    const bool entered = hit.distance < inside * gap && gap > shortest * h;
    if (!entered && gap <= longest * h) return;
    double share = 0.5;
    if (entered)
      share = std::clamp(dot(points_[hit.index] - p.position, along) / (gap * gap), least_share,
                         1 - least_share);
    const Vec3 start = p.position + share * along;
    const auto x = meet(a, b, start, least_sine);
    if (!x || distance(*x, start) > largest_move * gap) return;
    if (is_occupied(*x, occupied * h)) return;
    grid_.add(*x, static_cast<Index>(all_.size()));
    all_.push_back(
        {*x, share * q.spacing + (1 - share) * p.spacing, false, p.near, no_index, {a, b}});
  }

  bool is_occupied(Vec3 x, double radius) const {
    bool occupied_by = nearest_(x).distance < radius;
    grid_.visit(x, radius, [&](Index i) {
      occupied_by = occupied_by || distance(all_[i].position, x) < radius;
      return !occupied_by;
    });
    return occupied_by;
  }

  bool is_side(Index u, Index v) const {
    if (u == no_index || v == no_index) return false;
    if (mesh_.star(u).size() > mesh_.star(v).size()) std::swap(u, v);
    return std::any_of(mesh_.star(u).begin(), mesh_.star(u).end(), [&](Index f) {
      const Triangle& t = mesh_.facets[f];
      return t[0] == v || t[1] == v || t[2] == v;
    });
  }

  // The next feature points on both surfaces along that direction and against it.
  std::array<Index, 2> next_both_ways(const FeaturePoint& p, const LocalSurface& a,
                                      const LocalSurface& b, Vec3 direction) const {
    std::array<Index, 2> best = {no_index, no_index};
    std::array<double, 2> nearest = {reach * p.spacing, reach * p.spacing};
    grid_.visit(p.position, reach * p.spacing, [&](Index i) {
      const Vec3 d = all_[i].position - p.position;
      const double far = length(d), along = dot(d, direction);
      const std::size_t way = along < 0;
      if (!(far > 0) || far >= nearest[way] || std::abs(along) < ahead * far) return true;
      if (!has(all_[i], a) || !has(all_[i], b)) return true;
      best[way] = i;
      nearest[way] = far;
      return true;
    });
    return best;
  }

  static bool has(const FeaturePoint& p, const LocalSurface& s) {
    if (!(std::abs(s.distance(p.position)) < same_distance * p.spacing)) return false;
    const Vec3 normal = s.normal(p.position);
    return std::any_of(p.surfaces.begin(), p.surfaces.end(), [&](const LocalSurface& o) {
      return dot(o.normal(p.position), normal) > same_cosine;
    });
  }

  const std::vector<Vec3>& points_;
  const NearestSample& nearest_;
  const FacetMesh& mesh_;
  std::vector<FeaturePoint>& all_;
  PointGrid grid_;
};

}  // namespace

void protect_curves(const std::vector<Vec3>& points, const NearestSample& nearest,
                    const FacetMesh& mesh, const std::vector<FeaturePoint>& marked,
                    std::vector<FeaturePoint>& features, Job& job) {
  std::vector<FeaturePoint> all = features;
  all.insert(all.end(), marked.begin(), marked.end());
  if (all.empty()) return;
  const auto [low, high] = std::minmax_element(
      all.begin(), all.end(),
      [](const FeaturePoint& p, const FeaturePoint& q) { return p.spacing < q.spacing; });
  const double smallest = low->spacing, largest = high->spacing;
  if (!(largest > 0)) return;
  const auto known = static_cast<std::ptrdiff_t>(all.size());
  Protector(points, nearest, mesh, all, smallest, largest).run(job);
  features.insert(features.end(), all.begin() + known, all.end());
}

}  // namespace arris
