#include "refine_stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.h"
#include "base/vec.h"
#include "cloud/nearest.h"
#include "feature/mesh_edges.h"
#include "feature/refine.h"
#include "seed/lifted.h"
#include "surface/extract.h"
#include "swap/flat.h"
#include "swap/swap.h"
#include "tetra/delaunay.h"

namespace arris {
namespace {

// Times that points are taken back. The second hardly finds any.
constexpr int most_attempts = 3;
// Points nearer than this to a vertex left out are taken back, in units of the spacing of the
// samples.
constexpr double withdrawal = 2;
// Gaps of random samples are edges longer than this, in units of spacing, if the surface stands off
// by as much. Measured on random samples of five mechanical parts: lengths of 2, 1.75 and 1.5 take
// 14, 20 and 26 % off the distance from the truth, at 0.4, 1 and 2.1 times the points.
constexpr RefineWish gaps = {.shortest = 1.75, .least_sag = 0.01};
// Fewer points than this share of the samples are not worth another cut. Evenly spread samples want
// less than 0.045, random ones of parts that are curved all over 0.05 to 0.3.
constexpr double least_share = 0.05;
// In units of spacing, which is half of that of the samples at points of the first round.
constexpr double second_sag = 0.006;
// Swaps are sought at edges that turn by more.
constexpr double sharp_turning = radians(30);
// An edge that turns by more is a fold.
constexpr double fold_turning = radians(150);

// The stage with the added points among its own.
Stage with_points(const Stage& stage, const Labels& labels, const LocalFrame& frame,
                  const std::vector<RefinePoint>& added, Job& job) {
  Stage next;
  next.model = stage.model;
  next.roughness = stage.roughness;
  Sides& sides = next.model.sides;
  if (sides.first.empty()) sides.first.assign(stage.mesh.points.size() + 1, 0);
  std::vector<Vec3> positions;
  std::vector<Index> near;
  std::vector<LiftedPoint> lifted;
  for (const RefinePoint& p : added) {
    positions.push_back(frame.to_local(frame.to_user(p.position)));
    near.push_back(p.near);
    lifted.push_back({p.foot, p.near, p.normals});
    next.model.spacing.push_back(p.spacing);
    sides.normal.insert(sides.normal.end(), p.normals.begin(), p.normals.end());
    sides.first.push_back(static_cast<Index>(sides.normal.size()));
  }
  Extension extension = add_points(stage.mesh, positions, near, job);
  next.mesh = std::move(extension.mesh);
  next.stars = Stars(next.mesh);
  next.seeds = lifted_seeds(stage.mesh, labels, stage.seeds, next.mesh, extension.former, lifted,
                            next.model.spacing, job);
  return next;
}

std::vector<std::uint8_t> on_surface(const Stage& stage, const Labels& labels) {
  return corners_of(boundary_triangles(stage.mesh, labels), stage.mesh.points.size());
}

// Takes back the added points near vertices that the new surface leaves out.
void withdraw(const Stage& old, const Labels& old_labels, const Stage& next, const Labels& labels,
              std::vector<RefinePoint>& added) {
  const std::vector<std::uint8_t> was = on_surface(old, old_labels), is = on_surface(next, labels);
  std::vector<Vec3> lost;
  for (std::size_t v = 0; v < is.size(); ++v)
    if (!is[v] && (v >= was.size() || was[v])) lost.push_back(next.mesh.points[v]);
  if (lost.empty()) return added.clear();
  const NearestSample nearest(lost);
  std::erase_if(added, [&](const RefinePoint& p) {
    return nearest(p.position).distance < withdrawal * 2 * p.spacing;
  });
}

Mesh surface_of(const Stage& stage, const Labels& labels) {
  Mesh mesh;
  mesh.vertices = stage.mesh.points;
  mesh.triangles = boundary_triangles(stage.mesh, labels);
  return mesh;
}

// 1 at the corners of facets at edges that turn by more than an angle.
std::vector<std::uint8_t> at_bends(const Mesh& surface, const MeshEdges& edges, double turning) {
  std::vector<std::uint8_t> bent(surface.vertices.size(), 0);
  for (const MeshEdge& e : edges.edges)
    if (std::abs(e.turning) > turning)
      for (Index f : e.faces)
        for (Index v : surface.triangles[f]) bent[v] = 1;
  return bent;
}

// 1 at the points from `known` on and at those that share a tetrahedron with one.
std::vector<std::uint8_t> near_added(const TetMesh& mesh, std::size_t known) {
  std::vector<std::uint8_t> near(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.finite; ++t) {
    const auto& corners = mesh.vertices[t];
    if (std::any_of(corners.begin(), corners.end(), [&](Index v) { return v >= known; }))
      for (Index v : corners) near[v] = 1;
  }
  return near;
}

// Swaps where the surface turns sharply and is new, and on from what they change. Beside features
// the cut leaves needles that stand up, as their area is next to nothing, and flat ones folded
// over. Elsewhere swaps would undo what the new points gain: they trade round triangles for flat
// ones. Far from the points added to the `known` ones they have been made before.
void swap_at_bends(const Stage& stage, std::size_t known, Labels& labels, Report& report,
                   Job& job) {
  const std::vector<std::uint8_t> near = near_added(stage.mesh, known);
  const Mesh surface = surface_of(stage, labels);
  const MeshEdges edges = collect_edges(surface, job);
  const auto bent = at_bends(surface, edges, sharp_turning);
  const auto folded = at_bends(surface, edges, fold_turning);
  SwapOptions options;
  options.keep_samples = report.options.keep_samples;
  options.frozen = flat_tetrahedra(stage.mesh, stage.model.spacing, job.threads());
  options.settled.assign(stage.mesh.size(), 1);
  options.with_energy = false;
  for (std::size_t t = 0; t < stage.mesh.finite; ++t) {
    const auto& corners = stage.mesh.vertices[t];
    const auto all = [&](const auto& marked) {
      return std::all_of(corners.begin(), corners.end(), [&](Index v) { return marked[v] != 0; });
    };
    const bool is_folded = all(folded);
    const bool is_near =
        std::any_of(corners.begin(), corners.end(), [&](Index v) { return near[v] != 0; });
    if (is_folded || (is_near && all(bent))) options.settled[t] = 0;
    if (is_folded) options.frozen[t] = 0;
  }
  report.swaps += swap_tetrahedra(stage.mesh, stage.model, options, labels, job).accepted;
}

// About how many sides span gaps of curved surface, by the normals at their ends. It is enough to
// see that evenly spread samples leave none, and asks for no edges and no features.
std::size_t count_gaps(const Mesh& surface, const std::vector<double>& spacing) {
  const std::vector<Vec3>& x = surface.vertices;
  std::vector<Vec3> normal(x.size());
  for (const Triangle& t : surface.triangles)
    for (Index v : t) normal[v] = normal[v] + cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]);
  for (Vec3& n : normal) n = normalized(n);
  std::size_t sides = 0;  // each of both of its facets
  for (const Triangle& t : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      const double h = (spacing[a] + spacing[b]) / 2, sag = dot(normal[b] - normal[a], x[b] - x[a]);
      sides += distance(x[a], x[b]) >= gaps.shortest * h && std::abs(sag) / 8 >= gaps.least_sag * h;
    }
  return sides / 2;
}

std::vector<RefinePoint> wanted_points(const RefineWish& wish, const Stage& stage,
                                       const Labels& labels, Job& job) {
  return refine_points(surface_of(stage, labels), stage.model.spacing, stage.roughness, wish, job);
}

// Returns the number of points added.
std::size_t add_to_surface(std::vector<RefinePoint> added, const Samples& samples, Stage& stage,
                           Labels& labels, Report& report, Job& job) {
  const Topology wanted = topology_of(stage.mesh, labels);
  for (int attempt = 0; attempt < most_attempts && !added.empty(); ++attempt) {
    Stage next = with_points(stage, labels, samples.frame, added, job);
    Report trial = report;
    SurfaceCut cut = cut_manifold(next, {}, trial, job);
    trial.cut_energy.push_back(cut.energy);
    if (topology_of(next.mesh, cut.labels) == wanted) {
      forget_evidence(next);
      stage = std::move(next);
      labels = std::move(cut.labels);
      report = std::move(trial);
      return added.size();
    }
    withdraw(stage, labels, next, cut.labels, added);
  }
  return 0;
}

}  // namespace

std::size_t refine_surface(const Samples& samples, Stage& stage, Labels& labels, Report& report,
                           Job& job) {
  const std::size_t known = stage.mesh.points.size();
  std::size_t added = 0;
  for (const RefineWish& wish : {RefineWish{}, RefineWish{.least_sag = second_sag}}) {
    const std::size_t more = add_to_surface(wanted_points(wish, stage, labels, job), samples, stage,
                                            labels, report, job);
    if (more == 0) break;
    added += more;
  }
  if (added > 0 && report.options.swap) swap_at_bends(stage, known, labels, report, job);
  return added;
}

std::size_t fill_gaps(const Samples& samples, Stage& stage, Labels& labels, Report& report,
                      Job& job) {
  const auto least =
      static_cast<std::size_t>(least_share * static_cast<double>(samples.points.size()));
  if (2 * count_gaps(surface_of(stage, labels), stage.model.spacing) < least) return 0;
  std::vector<RefinePoint> wanted = wanted_points(gaps, stage, labels, job);
  if (wanted.size() < least) return 0;
  const std::size_t known = stage.mesh.points.size();
  const std::size_t added = add_to_surface(std::move(wanted), samples, stage, labels, report, job);
  if (added > 0 && report.options.swap) swap_at_bends(stage, known, labels, report, job);
  return added;
}

}  // namespace arris
