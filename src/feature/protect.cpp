#include "feature/protect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>

#include "cloud/nearest.h"
#include "feature/meet.h"

namespace arris {
namespace {

double env(const char* name, double value) {
  const char* s = std::getenv(name);
  return s ? std::atof(s) : value;
}

class Protector {
 public:
  Protector(const std::vector<Vec3>& points, std::vector<FeaturePoint>& features)
      : points_(points), features_(features), nearest_(points) {
    for (const FeaturePoint& f : features_) cell_ = std::max(cell_, reach_ * f.spacing);
    for (Index i = 0; i < features_.size(); ++i) place(i);
  }

  void run() {
    for (Index i = 0; i < features_.size(); ++i) gaps_of(i);  // grows while it runs
  }

 private:
  void gaps_of(Index i) {
    const FeaturePoint f = features_[i];
    for (std::size_t a = 0; a < f.surfaces.size(); ++a)
      for (std::size_t b = a + 1; b < f.surfaces.size(); ++b) {
        const Vec3 t = cross(f.surfaces[a].normal(f.position), f.surfaces[b].normal(f.position));
        const double len = length(t);
        if (len < 0.1) continue;
        for (double sign : {1.0, -1.0})
          gap(i, f.surfaces[a], f.surfaces[b], (sign / len) * t);
      }
  }

  void gap(Index i, const LocalSurface& a, const LocalSurface& b, Vec3 direction) {
    const FeaturePoint f = features_[i];
    const Index j = next(f, a, b, direction);
    if (j == no_index) return;
    const Vec3 p = f.position, q = features_[j].position;
    const double gap = distance(p, q), h = std::min(f.spacing, features_[j].spacing);
    const Vec3 middle = 0.5 * (p + q);
    const NearestSample::Hit hit = nearest_(middle);
    const bool entered = hit.distance < 0.499 * gap && gap > shortest_ * h;
    if (!entered && gap <= longest_ * h) return;
    double share = 0.5;
    if (entered) {
      share = dot(points_[hit.index] - p, q - p) / (gap * gap);
      share = std::clamp(share, 0.25, 0.75);
    }
    const Vec3 start = p + share * (q - p);
    const auto x = meet(a, b, start, 0.1);
    if (!x || distance(*x, start) > 0.3 * gap) return;
    if (nearest_(*x).distance < 0.01 * h) return;
    features_.push_back({*x, share * features_[j].spacing + (1 - share) * f.spacing, false, {a, b}});
    place(static_cast<Index>(features_.size() - 1));
  }

  // The feature nearest in the direction that lies on both surfaces.
  Index next(const FeaturePoint& f, const LocalSurface& a, const LocalSurface& b,
             Vec3 direction) const {
    const auto key = key_of(f.position);
    Index best = no_index;
    double best_distance = reach_ * f.spacing;
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k) {
          const auto it = cells_.find({key[0] + i, key[1] + j, key[2] + k});
          if (it == cells_.end()) continue;
          for (Index other : it->second) {
            const Vec3 d = features_[other].position - f.position;
            const double far = length(d);
            if (far >= best_distance || dot(d, direction) < 0.9 * far || !(far > 0)) continue;
            if (!has(features_[other], a) || !has(features_[other], b)) continue;
            best = other;
            best_distance = far;
          }
        }
    return best;
  }

  static bool has(const FeaturePoint& f, const LocalSurface& s) {
    for (const LocalSurface& o : f.surfaces)
      if (dot(o.normal(f.position), s.normal(f.position)) > 0.97 &&
          std::abs(s.distance(f.position)) < 0.1 * f.spacing)
        return true;
    return false;
  }
  std::array<long, 3> key_of(Vec3 x) const {
    return {std::lround(std::floor(x.x / cell_)), std::lround(std::floor(x.y / cell_)),
            std::lround(std::floor(x.z / cell_))};
  }
  void place(Index i) { cells_[key_of(features_[i].position)].push_back(i); }

  const std::vector<Vec3>& points_;
  std::vector<FeaturePoint>& features_;
  NearestSample nearest_;
  double reach_ = 2.5, longest_ = env("LONGEST", 0.8), shortest_ = env("SHORTEST", 0.3);
  double cell_ = 0;
  std::map<std::array<long, 3>, std::vector<Index>> cells_;
};

}  // namespace

void protect_curves(const std::vector<Vec3>& points, std::vector<FeaturePoint>& features, Job&) {
  Protector(points, features).run();
}

}  // namespace arris
