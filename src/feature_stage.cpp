#include "feature_stage.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "base/vec.h"
#include "feature/between.h"
#include "feature/extend.h"
#include "feature/insert.h"
#include "feature/sense.h"
#include "feature_trial.h"
#include "seed/transfer.h"
#include "surface/extract.h"
#include "tetra/delaunay.h"

namespace arris {
namespace {

// The surface that was sensed on, where, and what was sensed.
struct SensedFacets {
  std::vector<Triangle> facets;
  std::vector<std::uint8_t> wanted;  // per point: 1 where it was sensed
  Sensed surfaces;
};

// Marks the corners of facets that do not lie along a known side of each of their corners: the
// surface does not follow what was sensed, or nothing was.
std::vector<std::uint8_t> at_open_facets(const FacetMesh& facets, const Sides& sides) {
  constexpr double along = 0.95;  // cosine; the surfaces of a feature differ by 20 degrees and more
  std::vector<std::uint8_t> open(sides.first.size() - 1, 0);
  for (std::size_t f = 0; f < facets.facets.size(); ++f) {
    const Vec3 normal = facets.normal[f];
    const auto has_side = [&](Index v) {
      const auto of_v = sides.at(v);
      return std::any_of(of_v.begin(), of_v.end(), [&](Vec3 n) { return dot(n, normal) > along; });
    };
    const Triangle& t = facets.facets[f];
    if (normal == Vec3{} || std::all_of(t.begin(), t.end(), has_side)) continue;
    for (Index v : t) open[v] = 1;
  }
  return open;
}

// Everywhere at first; then only round the features that were found, where the surface is new, and
// only where it does not follow yet what was sensed. Measured on five clouds: with two, three or
// four rings as many features are found as everywhere, to five in a thousand.
std::vector<std::uint8_t> places_to_sense(const FacetMesh& facets, const Sides& sides,
                                          std::size_t points, std::size_t samples) {
  constexpr int new_rings = 3, open_rings = 2;
  std::vector<std::uint8_t> wanted = near_bends(facets, points);
  if (points == samples) return wanted;
  std::vector<std::uint8_t> fresh(points, 0), open = at_open_facets(facets, sides);
  std::fill(fresh.begin() + static_cast<std::ptrdiff_t>(samples), fresh.end(), 1);
  spread(facets.facets, new_rings, fresh);
  for (std::size_t v = 0; v < points; ++v) open[v] = open[v] && wanted[v] && fresh[v];
  spread(facets.facets, open_rings, open);
  for (std::size_t v = 0; v < points; ++v) wanted[v] = wanted[v] && fresh[v] && open[v];
  return wanted;
}

std::vector<std::vector<LocalSurface>> surfaces_of(const std::vector<FeaturePoint>& features) {
  std::vector<std::vector<LocalSurface>> surfaces;
  surfaces.reserve(features.size());
  for (const FeaturePoint& p : features) surfaces.push_back(p.surfaces);
  return surfaces;
}

// Appends the new feature points, where the user's frame can hold them exactly. Of the facets only
// the corners are kept, for what comes next takes much memory.
SensedFacets sense_features(const Stage& stage, const Labels& labels, const Samples& given,
                            const RefusedFeatures& refused, std::vector<FeaturePoint>& features,
                            Job& job) {
  const std::size_t samples = given.points.size(), known = features.size();
  const std::vector<Vec3>& points = stage.mesh.points;
  FacetMesh mesh(boundary_triangles(stage.mesh, labels), points, job.threads());
  std::vector<std::uint8_t> wanted =
      places_to_sense(mesh, stage.model.sides, points.size(), samples);
  Sensed sensed = sense_surfaces(points, mesh, stage.model.spacing, wanted, surfaces_of(features),
                                 stage.roughness, job);
  insert_feature_points(points, samples, mesh, stage.model.spacing, sensed, refused.across,
                        features, job);
  for (std::size_t k = known; k < features.size(); ++k)
    features[k].position = given.frame.to_local(given.frame.to_user(features[k].position));
  const auto is_refused = [&](const FeaturePoint& p) {
    return std::binary_search(refused.at_handles.begin(), refused.at_handles.end(), p.position,
                              lexicographic_less);
  };
  features.erase(std::remove_if(features.begin() + static_cast<std::ptrdiff_t>(known),
                                features.end(), is_refused),
                 features.end());
  return {std::move(mesh.facets), std::move(wanted), std::move(sensed)};
}

// Where nothing was sensed anew (`wanted`), those `known` before.
Sides sides_of(const std::vector<Vec3>& points, const SurfacesAt& surfaces_at, const Sides& known,
               const std::vector<std::uint8_t>& wanted, std::size_t samples) {
  Sides sides;
  sides.first.push_back(0);
  for (Index v = 0; v < points.size(); ++v) {
    if (v < samples && !wanted[v] && !known.first.empty()) {
      const auto former = known.at(v);
      sides.normal.insert(sides.normal.end(), former.begin(), former.end());
    }
    for (const LocalSurface& s : surfaces_at(v)) sides.normal.push_back(s.normal(points[v]));
    sides.first.push_back(static_cast<Index>(sides.normal.size()));
  }
  return sides;
}

// Points of the mesh before round which the surface will be new: where a point is added, and at
// tetrahedra that were there and are now known to have the other label.
std::vector<Index> unsettled_points(const std::vector<Index>& near, const Labels& labels,
                                    const Extension& extension, const std::vector<Seed>& known) {
  std::vector<Index> points = near;
  for (Tet t = 0; t < extension.mesh.finite; ++t) {
    const Tet former = extension.former[t];
    if (former == no_tet || known[t] == seed_free || known[t] == labels[former]) continue;
    for (Index v : extension.mesh.vertices[t]) points.push_back(v);
  }
  return points;
}

// Tetrahedra of the extended mesh that were there before, with all corners more than a few rings
// from every added and every unsettled point: the cut need not look at them again. Measured on six
// models: with three rings the figures are those of cutting and swapping everything, with two
// almost.
std::vector<std::uint8_t> far_from(const std::vector<Index>& unsettled, std::size_t added,
                                   const std::vector<Triangle>& facets, const Extension& extension,
                                   unsigned threads) {
  constexpr int rings = 3;
  const TetMesh& mesh = extension.mesh;
  std::vector<std::uint8_t> fresh(mesh.points.size(), 1);
  std::fill(fresh.begin(), fresh.end() - static_cast<std::ptrdiff_t>(added), 0);
  for (Index v : unsettled) fresh[v] = 1;
  spread(facets, rings, fresh);
  std::vector<std::uint8_t> far(mesh.size(), 0);
  parallel_for(mesh.finite, threads, [&](std::size_t t) {
    const auto& corners = mesh.vertices[t];
    far[t] = extension.former[t] != no_tet &&
             std::none_of(corners.begin(), corners.end(), [&](Index v) { return fresh[v]; });
  });
  return far;
}

// Of those, the ones that were settled before, too.
std::vector<std::uint8_t> still_settled(const std::vector<std::uint8_t>& before,
                                        const std::vector<Tet>& former,
                                        std::vector<std::uint8_t> far) {
  if (!before.empty())
    for (std::size_t t = 0; t < far.size(); ++t) far[t] = far[t] && before[former[t]];
  return far;
}

// Adds the feature points that the surface of `labels` lets sense, but for refused ones, to
// `features`; returns the stage that has them among its points, or nothing (no points) if there is
// none to add.
Stage with_features(const Stage& stage, const Labels& labels, const Samples& given,
                    const RefusedFeatures& refused, std::vector<FeaturePoint>& features, Job& job) {
  Stage next;
  const std::size_t samples = given.points.size();
  const std::size_t known = features.size();
  const SensedFacets sensed = sense_features(stage, labels, given, refused, features, job);
  if (features.size() == known) return next;
  std::vector<Vec3> added;
  std::vector<Index> near;
  next.model = stage.model;
  next.roughness = stage.roughness;
  for (std::size_t k = known; k < features.size(); ++k) {
    added.push_back(features[k].position);
    near.push_back(features[k].near);
    next.model.spacing.push_back(features[k].spacing);
  }
  Extension extension = add_points(stage.mesh, added, near, job);
  // At the samples as sensed now, at the features as they were made.
  const SurfacesAt surfaces_at = [&](Index v) {
    return v < samples ? sensed.surfaces.at(v)
                       : std::span<const LocalSurface>(features[v - samples].surfaces);
  };
  const std::vector<Seed> known_seeds =
      tetrahedra_between(extension.mesh, next.model.spacing, surfaces_at, stage.roughness, job);
  const std::vector<std::uint8_t> far =
      far_from(unsettled_points(near, labels, extension, known_seeds), added.size(), sensed.facets,
               extension, job.threads());
  next.mesh = std::move(extension.mesh);
  next.stars = Stars(next.mesh);
  next.model.sides =
      sides_of(next.mesh.points, surfaces_at, stage.model.sides, sensed.wanted, samples);
  next.seeds = follow_seeds(stage.mesh, labels, stage.seeds, next.mesh, extension.former, near,
                            next.model.spacing, far, known_seeds, job);
  extend_across_gaps(next.mesh, features, known, next.seeds);
  next.settled = still_settled(stage.settled, extension.former, far);
  return next;
}

}  // namespace

bool add_features(const Samples& samples, Stage& stage, Labels& labels,
                  std::vector<FeaturePoint>& features, Report& report, Job& job) {
  const std::size_t known = features.size();
  const std::uint64_t flips = report.manifold_flips;
  RefusedFeatures refused;
  for (;;) {
    report.manifold_flips = flips;
    Stage next = with_features(stage, labels, samples, refused, features, job);
    if (features.size() == known) return false;
    SurfaceCut cut = cut_manifold(next, {}, report, job);
    forget_evidence(next);
    const FeatureTrial trial{
        next.mesh.points, next.model.spacing, boundary_triangles(stage.mesh, labels),
        boundary_triangles(next.mesh, cut.labels), std::span(features).subspan(known)};
    if (refuse_features(trial, refused)) {
      features.resize(known);
      continue;
    }
    if (!has_inside(cut.labels)) {  // a handful of points: the features were none
      features.resize(known);
      return false;
    }
    stage = std::move(next);
    labels = std::move(cut.labels);
    report.cut_energy.push_back(cut.energy);
    return true;
  }
}

}  // namespace arris
