#include "feature/sense.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "feature/patch.h"

namespace arris {
namespace {

// Two surfaces at one point are two sides of a feature if their normals differ by this much.
const double least_crease = std::cos(20 * std::numbers::pi / 180);
// Levels of tolerance, the strictest that finds a patch is taken: flat faces pass the first.
constexpr double levels[] = {4, 9, 18};

const double on_surface = std::getenv("ON") ? std::atof(std::getenv("ON")) : 0.005;

class Senser {
 public:
  Senser(const std::vector<Vec3>& points, const FacetMesh& mesh,
         const std::vector<double>& spacing)
      : grower_(points, mesh, spacing), points_(points), mesh_(mesh), spacing_(spacing) {}

  void sense(Index v, std::vector<LocalSurface>& out) {
    for (double level : levels) {
      sense_at(v, level * std::numbers::pi / 180, out);
      if (!out.empty()) return;
    }
  }

 private:
  void sense_at(Index v, double angle, std::vector<LocalSurface>& out) {
    std::vector<Patch> found;
    for (Index f : mesh_.star(v)) {
      bool covered = false;
      for (const Patch& p : found)
        covered |= std::find(p.facets.begin(), p.facets.end(), f) != p.facets.end();
      if (covered) continue;
      Patch p = grower_.grow(v, f, angle);
      if (grower_.is_large(p, v)) found.push_back(std::move(p));
    }
    std::sort(found.begin(), found.end(), [](const Patch& a, const Patch& b) {
      return a.members.size() > b.members.size();
    });
    for (const Patch& p : found) {
      bool distinct = std::abs(p.surface.distance(points_[v])) <= on_surface * spacing_[v];
      for (const LocalSurface& s : out)
        distinct &= dot(s.normal(points_[v]), p.surface.normal(points_[v])) < least_crease;
      if (distinct) out.push_back(p.surface);
    }
  }

  PatchGrower grower_;
  const std::vector<Vec3>& points_;
  const FacetMesh& mesh_;
  const std::vector<double>& spacing_;
};

void ring(const FacetMesh& mesh, Index v, std::vector<Index>& near) {
  near.clear();
  for (Index f : mesh.star(v))
    for (Index w : mesh.facets[f])
      for (Index g : mesh.star(w))
        for (Index x : mesh.facets[g])
          if (x != v && std::find(near.begin(), near.end(), x) == near.end()) near.push_back(x);
}

// A surface found at `owner`.
struct Proposal {
  const LocalSurface* surface;
  Index owner;
  int support = 0;
};

struct Tolerance {
  double distance, angle;  // in units of spacing; radians
};
constexpr Tolerance tight = {0.005, 2 * std::numbers::pi / 180};
constexpr Tolerance loose = {0.05, 8 * std::numbers::pi / 180};
constexpr int least_support = 3;

// Settles which surfaces pass through each sample: those that most samples round it have found.
class Council {
 public:
  Council(const std::vector<Vec3>& points, const FacetMesh& mesh,
          const std::vector<double>& spacing, const std::vector<std::vector<LocalSurface>>& found)
      : points_(points), mesh_(mesh), spacing_(spacing), found_(found) {}

  void settle(Index v, std::vector<LocalSurface>& out) {
    ring(mesh_, v, near_);
    near_.push_back(v);
    for (const Tolerance& t : {tight, loose}) {
      propose(v, t);
      for (Proposal& p : proposals_) p.support = support(p, v, t);
      std::stable_sort(proposals_.begin(), proposals_.end(), [&](const Proposal& a, const Proposal& b) {
        if (a.support != b.support) return a.support > b.support;
        return (a.owner == v) > (b.owner == v);
      });
      for (const Proposal& p : proposals_) {
        if (p.support < least_support) break;
        bool distinct = true;
        for (const LocalSurface& s : out)
          distinct &= dot(s.normal(points_[v]), p.surface->normal(points_[v])) < least_crease;
        if (distinct) out.push_back(*p.surface);
      }
      if (!out.empty()) return;
    }
  }

 private:
  void propose(Index v, Tolerance t) {
    proposals_.clear();
    for (Index w : near_)
      for (const LocalSurface& s : found_[w])
        if ((w == v || t.distance == tight.distance) && std::abs(s.distance(points_[v])) <= on_surface * spacing_[v])
          proposals_.push_back({&s, w});
  }
  int support(const Proposal& p, Index v, Tolerance t) const {
    int count = 0;
    const Vec3 n = p.surface->normal(points_[v]);
    const double far = t.distance * spacing_[v], cosine = std::cos(t.angle);
    for (Index w : near_) {
      if (w == v || std::abs(p.surface->distance(points_[w])) > far) continue;
      for (const LocalSurface& o : found_[w])
        if (std::abs(o.distance(points_[v])) <= far && dot(o.normal(points_[v]), n) >= cosine) {
          ++count;
          break;
        }
    }
    return count;
  }

  const std::vector<Vec3>& points_;
  const FacetMesh& mesh_;
  const std::vector<double>& spacing_;
  const std::vector<std::vector<LocalSurface>>& found_;
  std::vector<Index> near_;
  std::vector<Proposal> proposals_;
};

}  // namespace

Sensed sense_surfaces(const std::vector<Vec3>& points, const FacetMesh& mesh,
                      const std::vector<double>& spacing, Job& job) {
  std::vector<std::vector<LocalSurface>> found(points.size());
  constexpr std::size_t grain = 1024;
  parallel_chunks(points.size(), grain, job.threads(), [&](std::size_t begin, std::size_t end) {
    Senser senser(points, mesh, spacing);
    for (std::size_t v = begin; v < end; ++v) senser.sense(static_cast<Index>(v), found[v]);
  });
  std::vector<std::vector<LocalSurface>> borne(points.size());
  parallel_chunks(points.size(), grain, job.threads(), [&](std::size_t begin, std::size_t end) {
    Council council(points, mesh, spacing, found);
    for (std::size_t v = begin; v < end; ++v)
      if (mesh.first[v] != mesh.first[v + 1]) council.settle(static_cast<Index>(v), borne[v]);
  });
  Sensed sensed;
  sensed.first.assign(points.size() + 1, 0);
  for (std::size_t v = 0; v < points.size(); ++v) {
    sensed.surface.insert(sensed.surface.end(), borne[v].begin(), borne[v].end());
    sensed.first[v + 1] = static_cast<Index>(sensed.surface.size());
  }
  return sensed;
}

}  // namespace arris
