#include "feature/spikes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <cstdlib>
#include <cstdio>

#include "base/parallel.h"
#include "base/vec.h"
#include "cloud/nearest.h"

namespace arris {
namespace {

double A = getenv("SA") ? atof(getenv("SA")) : 0.3;
double B = getenv("SB") ? atof(getenv("SB")) : 4;
double Q = getenv("SQ") ? atof(getenv("SQ")) : 0.8;

// A triangle explains nothing if its area is below this share of the squared spacing.
constexpr double smallest_area = 0.05;

// Triangles at every point, in compressed rows.
class Umbrellas {
 public:
  Umbrellas(std::size_t points, const std::vector<Triangle>& triangles) : start_(points + 1, 0) {
    for (const Triangle& t : triangles)
      for (Index v : t) ++start_[v + 1];
    for (std::size_t v = 0; v < points; ++v) start_[v + 1] += start_[v];
    list_.resize(start_[points]);
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (Index v : triangles[t]) list_[next[v]++] = static_cast<Index>(t);
  }
  std::span<const Index> operator[](Index v) const noexcept {
    return {list_.data() + start_[v], list_.data() + start_[v + 1]};
  }

 private:
  std::vector<std::size_t> start_;
  std::vector<Index> list_;
};

// Distinct entries, in order.
void make_set(std::vector<Index>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

class Finder {
 public:
  Finder(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
         const std::vector<double>& spacing)
      : points_(points),
        triangles_(triangles),
        spacing_(spacing),
        umbrellas_(points.size(), triangles),
        unexplained_(points.size(), 0) {}

  std::vector<std::uint8_t> run(Job& job) {
    prepare_absent();
    parallel_for(points_.size(), job.threads(), [&](std::size_t p) {
      unexplained_[p] = unexplained(static_cast<Index>(p));
    });
    job.tick(0.5);
    std::vector<std::uint8_t> spike(points_.size(), 0);
    parallel_for(points_.size(), job.threads(),
                 [&](std::size_t p) { spike[p] = is_spike(static_cast<Index>(p)); });
    return spike;
  }
  std::vector<double> un() { return unexplained_; }
  double level(Index p) const {
    std::vector<double> s;
    for (Index v : company(p)) s.push_back(unexplained_[v]);
    if (s.empty()) return 0;
    auto m = s.begin() + (std::ptrdiff_t)((double)(s.size() - 1) * Q);
    std::nth_element(s.begin(), m, s.end());
    return *m;
  }

 private:
  void prepare_absent() {
    for (Index p = 0; p < points_.size(); ++p)
      if (!umbrellas_[p].empty()) {
        present_.push_back(p);
        present_points_.push_back(points_[p]);
      }
    if (!present_.empty()) tree_ = std::make_unique<NearestSample>(present_points_);
  }

  // The points joined to p by an edge; for a point off the surface the nearest on it.
  std::vector<Index> ring(Index p) const {
    std::vector<Index> ring;
    for (Index t : umbrellas_[p])
      for (Index v : triangles_[t])
        if (v != p) ring.push_back(v);
    if (ring.empty() && tree_) {
      std::vector<NearestSample::Hit> hits;
      tree_->nearest(points_[p], 4, hits);
      for (const auto& h : hits) ring.push_back(present_[h.index]);
    }
    make_set(ring);
    return ring;
  }

  // Triangles that touch the ring of p, but not p.
  std::vector<Index> facets(Index p) const {
    std::vector<Index> facets;
    for (Index v : ring(p))
      for (Index t : umbrellas_[v])
        if (std::find(triangles_[t].begin(), triangles_[t].end(), p) == triangles_[t].end())
          facets.push_back(t);
    make_set(facets);
    return facets;
  }

  double unexplained(Index p) const {
    double least = std::numeric_limits<double>::infinity();
    const double h = spacing_[p];
    for (Index t : facets(p)) {
      const Vec3 a = points_[triangles_[t][0]];
      const Vec3 normal = cross(points_[triangles_[t][1]] - a, points_[triangles_[t][2]] - a);
      const double twice_area = length(normal);
      if (twice_area < 2 * smallest_area * h * h) continue;
      least = std::min(least, std::abs(dot(points_[p] - a, normal)) / (twice_area * h));
    }
    return least;
  }

  // The points of the facets of p.
  std::vector<Index> company(Index p) const {
    std::vector<Index> points;
    for (Index t : facets(p))
      for (Index v : triangles_[t]) points.push_back(v);
    make_set(points);
    return points;
  }

  bool is_spike(Index p) const {
    if (unexplained_[p] < A) return false;
    return unexplained_[p] > B * level(p);
  }

  const std::vector<Vec3>& points_;
  const std::vector<Triangle>& triangles_;
  const std::vector<double>& spacing_;
  Umbrellas umbrellas_;
  std::vector<double> unexplained_;
  std::vector<Index> present_;
  std::vector<Vec3> present_points_;
  std::unique_ptr<NearestSample> tree_;
};

}  // namespace

std::vector<std::uint8_t> find_spikes(const std::vector<Vec3>& points,
                                      const std::vector<Triangle>& triangles,
                                      const std::vector<double>& spacing, Job& job) {
  Finder f(points, triangles, spacing);
  auto r = f.run(job);
  if (getenv("SDUMP")) {
    auto u = f.un();
    for (Index p = 0; p < points.size(); ++p)
      if (u[p] > 0.15) printf("U %u %.3f %.3f %d\n", p, u[p], f.level(p), int(r[p]));
  }
  return r;
}

}  // namespace arris
