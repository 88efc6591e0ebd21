#include "handles_stage.h"

#include <algorithm>
#include <utility>

#include "base/distinct.h"
#include "base/vec.h"
#include "feature/facets.h"
#include "seed/parity_forest.h"
#include "surface/extract.h"
#include "surface/short_loops.h"
#include "tetra/locate.h"

namespace arris {
namespace {

// Of the longest loop that is mended. A tunnel that is there has more samples round it: on first
// surfaces of right topology of the 38 models, clean and noisy, the shortest loop has 7 sides where
// density is graded ten to one, else 8; most of what noise makes has 3 to 5.
constexpr int most_sides = 5;
// And of the shortest that crosses it, through the tunnel if the one goes round the bar, or the
// other way round. Of the handles of noise and wedge tips most have 14 at most; a ring of bars one
// spacing wide has as many as it is long, and stays.
constexpr int most_across = 14;
// No side of it is longer, in units of spacing: that is a gap of the samples.
constexpr double longest_side = 2;
// Places along each side of the triangles of a disc; tetrahedra there are about a spacing wide.
constexpr int steps = 6;
// Loops that share a point are mended one after another.
constexpr int most_rounds = 4;

// The tetrahedra of the more frequent label that hold places on the disc that a loop spans, a cone
// over its middle.
std::vector<Tet> across(const Stage& stage, const Labels& labels, const std::vector<Index>& loop) {
  const std::vector<Vec3>& x = stage.mesh.points;
  Vec3 c;
  for (Index v : loop) c = c + 1.0 / static_cast<double>(loop.size()) * x[v];
  std::vector<Tet> tets;
  Tet at = stage.stars[loop[0]][0];
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3 a = x[loop[k]] - c, b = x[loop[(k + 1) % loop.size()]] - c;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; i + j < steps; ++j) {
        at = locate(stage.mesh, c + (i + 1.0 / 3) / steps * a + (j + 1.0 / 3) / steps * b, at);
        tets.push_back(at);
      }
  }
  const auto inside =
      std::count_if(tets.begin(), tets.end(), [&](Tet t) { return labels[t] != 0; });
  const bool is_inside = 2 * inside > std::ssize(tets);
  keep_distinct(tets);
  std::erase_if(tets, [&](Tet t) { return t >= stage.mesh.finite || labels[t] != is_inside; });
  return tets;
}

// Adds those of the same label that have `least` corners or more among `corners`, ascending.
void add_round(const Stage& stage, const Labels& labels, const std::vector<Index>& corners,
               std::ptrdiff_t least, std::vector<Tet>& tets) {
  if (tets.empty()) return;
  const std::uint8_t label = labels[tets[0]];
  for (Index v : corners)
    for (Tet t : stage.stars[v]) {
      if (t >= stage.mesh.finite || labels[t] != label) continue;
      const auto& w = stage.mesh.vertices[t];
      const auto shared = std::count_if(w.begin(), w.end(), [&](Index u) {
        return std::binary_search(corners.begin(), corners.end(), u);
      });
      if (shared >= least) tets.push_back(t);
    }
  keep_distinct(tets);
}

// How thick a plug is: the tetrahedra across the disc; with those between their corners; with those
// at two points of the loop.
enum class Plug : std::uint8_t { disc, between, round };

std::vector<Tet> plug(const Stage& stage, const Labels& labels, std::vector<Index> loop, Plug how) {
  std::vector<Tet> tets = across(stage, labels, loop);
  std::vector<Index> corners;
  if (how == Plug::between)
    for (Tet t : tets)
      for (Index v : stage.mesh.vertices[t]) corners.push_back(v);
  else
    corners = std::move(loop);
  keep_distinct(corners);
  if (how != Plug::disc) add_round(stage, labels, corners, how == Plug::between ? 4 : 2, tets);
  return tets;
}

// Takes back the changes that did not make a handle less: sets of changed tetrahedra joined by
// their corners. The star of each point is then as it was or as it is.
void take_back(const TetMesh& mesh, const Labels& labels, const ChangedRegions& regions,
               Labels& mended) {
  ParityForest sets(mesh.points.size());
  std::vector<Tet> changed;
  for (Tet t = 0; t < mesh.finite; ++t)
    if (labels[t] != mended[t]) changed.push_back(t);
  for (Tet t : changed)
    for (Index v : mesh.vertices[t]) sets.join(mesh.vertices[t][0], v, false);
  std::vector<std::uint8_t> counted(regions.handles.size(), 0);
  std::vector<std::int64_t> handles(mesh.points.size(), 0);
  for (Index v = 0; v < regions.of.size(); ++v)
    if (const Index r = regions.of[v]; r != no_index && !std::exchange(counted[r], std::uint8_t{1}))
      handles[sets.find(v).node] += regions.handles[r];
  for (Tet t : changed)
    if (handles[sets.find(mesh.vertices[t][0]).node] >= 0) mended[t] = labels[t];
}

// Loops round the handles that are too small, on the surface of these triangles.
std::vector<std::vector<Index>> small_loops(const Stage& stage,
                                            const std::vector<Triangle>& triangles, Job& job) {
  const std::vector<Vec3>& points = stage.mesh.points;
  const Topology topology = topology_of(triangles, points.size());
  if (topology.euler == 2 * static_cast<std::int64_t>(topology.components)) return {};
  const FacetMesh facets(triangles, points, job.threads());
  auto loops = short_loops(facets, points, stage.model.spacing, most_sides, longest_side);
  std::erase_if(loops, [&](const auto& loop) {
    return sides_across(facets, loop, most_across) > most_across;
  });
  return loops;
}

// Mends loops on the surface of the labels, which is `before`; returns whether any was.
bool mend_loops(Stage& stage, const std::vector<std::vector<Index>>& loops,
                const std::vector<Triangle>& before, Plug how, Labels& labels, Report& report,
                Job& job) {
  const TetMesh& mesh = stage.mesh;
  stage.stars = Stars(mesh);
  Labels mended = labels;
  for (const std::vector<Index>& loop : loops)
    for (Tet t : plug(stage, labels, loop, how)) mended[t] = !labels[t];
  Report trial = report;
  remanifold(stage, mended, trial, job);
  stage.stars = {};
  const std::vector<Triangle> after = boundary_triangles(mesh, mended);
  take_back(mesh, labels, changed_regions(before, after, mesh.points.size()), mended);
  if (mended == labels) return false;
  labels = std::move(mended);
  report = std::move(trial);
  return true;
}

}  // namespace

void mend_handles(Stage& stage, Labels& labels, Report& report, Job& job) {
  for (const Plug how : {Plug::disc, Plug::between, Plug::round})
    for (int round = 0; round < most_rounds; ++round) {
      const std::vector<Triangle> before = boundary_triangles(stage.mesh, labels);
      const auto loops = small_loops(stage, before, job);
      if (loops.empty()) return;
      if (!mend_loops(stage, loops, before, how, labels, report, job)) break;
    }
}

}  // namespace arris
