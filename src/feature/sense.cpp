#include "feature/sense.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "feature/adopt.h"
#include "feature/council.h"
#include "feature/patch.h"
#include "feature/small_planes.h"

namespace arris {
namespace {

// Where no side within two rings bends by more than this, no feature of twice the angle can be.
constexpr double least_bend = radians(8);
// Tolerances of a patch, the strictest that finds one is taken: flat faces pass the first, a
// cylinder of five spacings radius the second.
constexpr std::array<double, 3> tolerances = {radians(4), radians(9), radians(18)};
constexpr std::size_t grain = 1024;  // points a chunk: sensing one takes about 20 microseconds

using Found = std::vector<std::vector<LocalSurface>>;

// The patches round one point, largest first, that pass through it and are no continuation of each
// other.
class Senser {
 public:
  Senser(const std::vector<Vec3>& points, const FacetMesh& mesh, const std::vector<double>& spacing,
         double roughness)
      : grower_(points, mesh, spacing, roughness),
        points_(points),
        mesh_(mesh),
        spacing_(spacing),
        roughness_(roughness) {}

  void sense(Index v, std::vector<LocalSurface>& out) {
    const double bend = least_bend_at(v);
    for (double tolerance : tolerances) {
      if (tolerance < bend && tolerance != tolerances.back()) continue;
      std::vector<Patch> found = patches(v, PatchTolerance(tolerance));
      std::stable_sort(found.begin(), found.end(), [](const Patch& a, const Patch& b) {
        return a.members.size() > b.members.size();
      });
      for (const Patch& p : found)
        if (p.surface.is_within(points_[v], on_surface_distance(spacing_[v], roughness_)))
          add_distinct(p.surface, points_[v], out);
      if (!out.empty()) return;
    }
  }

 private:
  // The least angle between two neighbouring facets of the star: no patch can be stricter.
  double least_bend_at(Index v) const {
    double cosine = -1;
    for (Index f : mesh_.star(v))
      for (Index g : mesh_.neighbours[f])
        cosine = std::max(cosine, dot(mesh_.normal[f], mesh_.normal[g]));
    return std::acos(std::min(cosine, 1.0));
  }

  // One from each facet of the star that those before do not cover.
  std::vector<Patch> patches(Index v, const PatchTolerance& tolerance) {
    std::vector<Patch> found;
    for (Index f : mesh_.star(v)) {
      const bool covered = std::any_of(found.begin(), found.end(), [&](const Patch& p) {
        return std::find(p.facets.begin(), p.facets.end(), f) != p.facets.end();
      });
      if (covered) continue;
      std::optional<Patch> p = grower_.grow(v, f, tolerance);
      if (p) found.push_back(std::move(*p));
    }
    return found;
  }

  PatchGrower grower_;
  const std::vector<Vec3>& points_;
  const FacetMesh& mesh_;
  const std::vector<double>& spacing_;
  double roughness_;
};

// Adds the planes of small faces, and exact planes from nearby, where no surface was settled.
void find_small_planes(const std::vector<Vec3>& points, const FacetMesh& mesh,
                       const std::vector<double>& spacing, const std::vector<std::uint8_t>& wanted,
                       std::size_t samples, Found& settled, Job& job) {
  std::vector<std::uint8_t> open(points.size(), 0);
  for (std::size_t v = 0; v < samples; ++v) open[v] = wanted[v] && settled[v].empty();
  parallel_chunks(samples, grain, job.threads(), [&](std::size_t begin, std::size_t end) {
    if (job.cancelled()) return;
    SmallPlanes small(points, mesh, spacing, open);
    for (std::size_t v = begin; v < end; ++v)
      if (open[v]) small.find(static_cast<Index>(v), settled[v]);
  });
  for (Index v = 0; v < samples; ++v) open[v] = open[v] || mesh.star(v).empty();
  adopt_planes(points, mesh, spacing, open, settled);
}

Sensed in_one_array(const Found& surfaces) {
  Sensed sensed;
  sensed.first.assign(1, 0);
  sensed.first.reserve(surfaces.size() + 1);
  for (const auto& at : surfaces)
    sensed.first.push_back(sensed.first.back() + static_cast<Index>(at.size()));
  sensed.surface.reserve(sensed.first.back());
  for (const auto& at : surfaces) sensed.surface.insert(sensed.surface.end(), at.begin(), at.end());
  return sensed;
}

}  // namespace

std::vector<std::uint8_t> near_bends(const FacetMesh& mesh, std::size_t points) {
  std::vector<std::uint8_t> marked = at_bends(mesh, least_bend, points);
  spread(mesh.facets, 2, marked);
  return marked;
}

Sensed sense_surfaces(const std::vector<Vec3>& points, const FacetMesh& mesh,
                      const std::vector<double>& spacing, const std::vector<std::uint8_t>& wanted,
                      const std::vector<std::vector<LocalSurface>>& known, double roughness,
                      Job& job) {
  Found found(points.size()), settled(points.size());
  const std::size_t open = points.size() - known.size();
  for (std::size_t v = open; v < points.size(); ++v)
    if (wanted[v]) found[v] = settled[v] = known[v - open];
  parallel_chunks(open, grain, job.threads(), [&](std::size_t begin, std::size_t end) {
    if (job.cancelled()) return;  // the next tick throws
    Senser senser(points, mesh, spacing, roughness);
    for (std::size_t v = begin; v < end; ++v)
      if (wanted[v]) senser.sense(static_cast<Index>(v), found[v]);
  });
  job.tick(0.7);
  parallel_chunks(open, grain, job.threads(), [&](std::size_t begin, std::size_t end) {
    if (job.cancelled()) return;
    Council council(points, mesh, spacing, found, roughness);
    for (std::size_t v = begin; v < end; ++v)
      if (wanted[v]) council.settle(static_cast<Index>(v), settled[v]);
  });
  release(found);
  if (roughness == 0) find_small_planes(points, mesh, spacing, wanted, open, settled, job);
  job.tick(1);
  return in_one_array(settled);
}

}  // namespace arris
