#include "cut/join.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/parallel.h"
#include "base/vec.h"
#include "cut/contract.h"
#include "cut/max_flow.h"
#include "cut/stumps.h"
#include "energy/facet.h"
#include "tetra/locate.h"

namespace arris {
namespace {

// Cost of a facet that carries the surface on, where one at right angles to it costs 1 more: area
// counts where directions do not decide. At 0.1 wide joins shrink from the corners they should
// fill.
constexpr double area_weight = 0.02;
// Steps along an axis to find the tetrahedra that it crosses; it need not find all.
constexpr int axis_steps = 64;
// Integer steps per unit of cost; what would not fit is never cut.
constexpr double capacity_steps = 0x1p20;
constexpr double largest_capacity = 0x1p30 - 1;

using Flags = std::vector<std::uint8_t>;  // per facet of the surface

// With the facets that touch a cap.
Flags with_rims(const CutSurface& s, const Flags& cap) {
  Flags loose = cap;
  for (std::size_t k = 0; k < cap.size(); ++k)
    if (cap[k])
      for (Index v : s.facets[k].corners)
        for (std::size_t n : s.round(v)) loose[n] = 1;
  return loose;
}

using Normals = std::vector<std::vector<Vec3>>;  // per point

// The normals of the facets that stay, at each of their corners; at the rim of a cap, those of the
// neighbours of its points, since the facets there may belong to the cap.
Normals normals_round(const CutSurface& s, const Flags& cap, const Flags& loose) {
  Normals own(s.points);
  for (std::size_t k = 0; k < s.facets.size(); ++k)
    if (!loose[k])
      for (Index v : s.facets[k].corners) own[v].push_back(s.facets[k].normal);
  Normals result = own;
  for (std::size_t k = 0; k < s.facets.size(); ++k) {
    if (!loose[k] || cap[k]) continue;
    for (Index v : s.facets[k].corners)
      for (Index w : s.facets[k].corners)
        if (v != w) result[v].insert(result[v].end(), own[w].begin(), own[w].end());
  }
  return result;
}

// Of facet i of t if t is inside and its neighbour outside: its area, and by how far it leans (one
// minus the cosine) from that side of each corner to which it is nearest, in the mean.
double facet_cost(const TetMesh& mesh, const std::vector<double>& spacing, const Normals& normals,
                  Tet t, std::size_t i) {
  const Vec3 n = facet_normal(mesh, t, static_cast<int>(i));
  const double twice = length(n);
  if (!(twice > 0)) return 0;
  double h = 0, lean = 0;
  int known = 0;
  for (int corner : facet_corners[i]) {
    const Index v = mesh.vertices[t][static_cast<std::size_t>(corner)];
    h += 1.0 / 3 * spacing[v];
    if (normals[v].empty()) continue;
    double best = -1;
    for (Vec3 side : normals[v]) best = std::max(best, dot(side, n) / twice);
    ++known;
    lean += 1 - best;
  }
  return (area_weight + (known > 0 ? lean / known : 0)) * 0.5 * twice / (h * h);
}

// Tetrahedra at facets that stay keep their labels.
std::vector<Seed> fixed_labels(const TetMesh& mesh, const CutSurface& s, const Flags& loose,
                               const Labels& labels) {
  std::vector<Seed> seed(mesh.size(), seed_free);
  std::fill(seed.begin() + static_cast<std::ptrdiff_t>(mesh.finite), seed.end(), seed_outside);
  for (std::size_t k = 0; k < s.facets.size(); ++k) {
    if (loose[k]) continue;
    const Tet t = s.facets[k].inside, n = mesh.neighbours[t][s.facets[k].i];
    seed[t] = labels[t];
    seed[n] = labels[n];
  }
  return seed;
}

// The tetrahedra along an axis; none if another part of the surface, or the outer world, is in
// between.
std::vector<Tet> tets_along(const TetMesh& mesh, const std::vector<Seed>& seed,
                            const std::array<Vec3, 2>& axis, Tet start) {
  std::vector<Tet> tets;
  for (int k = 1; k < axis_steps; ++k) {
    const Vec3 p = axis[0] + static_cast<double>(k) / axis_steps * (axis[1] - axis[0]);
    const Tet t = locate(mesh, p, start);
    if (seed[t] == seed_outside) return {};
    if (seed[t] == seed_free) tets.push_back(t);
    start = t;
  }
  return tets;
}

// The tetrahedra along all axes are inside. Returns the joins: caps, less groups of joined caps.
std::size_t join_along(const TetMesh& mesh, const Stumps& stumps, std::vector<Seed>& seed) {
  const std::vector<Seed> given = seed;
  std::vector<std::size_t> group(stumps.caps);
  std::iota(group.begin(), group.end(), std::size_t{0});
  std::size_t joins = 0;
  for (const Stumps::Axis& axis : stumps.axes) {
    const std::vector<Tet> along = tets_along(mesh, given, axis.ends, 0);
    for (Tet t : along) seed[t] = seed_inside;
    if (along.empty() || group[axis.from] == group[axis.to]) continue;
    ++joins;
    std::replace(group.begin(), group.end(), std::size_t{group[axis.from]},
                 std::size_t{group[axis.to]});
  }
  return joins;
}

// Capacities of all facets that are not between two known labels.
void fill_capacities(const TetMesh& mesh, const std::vector<double>& spacing,
                     const Normals& normals, unsigned threads, CutProblem& problem) {
  problem.capacity.assign(mesh.size(), {0, 0, 0, 0});
  parallel_for(mesh.finite, threads, [&](std::size_t k) {
    const auto t = static_cast<Tet>(k);
    for (std::size_t i = 0; i < 4; ++i) {
      if (problem.seed[t] != seed_free && problem.seed[mesh.neighbours[t][i]] != seed_free)
        continue;
      const double steps = capacity_steps * facet_cost(mesh, spacing, normals, t, i);
      problem.capacity[t][i] =
          static_cast<std::int32_t>(std::min(std::floor(steps), largest_capacity));
    }
  });
}

}  // namespace

std::size_t join_stumps(const TetMesh& mesh, const std::vector<double>& spacing, Labels& labels,
                        Job& job) {
  if (find_stumps(mesh, surface_near_gaps(mesh, spacing, labels)).axes.empty()) return 0;
  const CutSurface surface = cut_surface_of(mesh, spacing, labels);
  const Stumps stumps = find_stumps(mesh, surface);
  const Flags loose = with_rims(surface, stumps.cap);
  CutProblem problem;
  problem.seed = fixed_labels(mesh, surface, loose, labels);
  const std::size_t joins = join_along(mesh, stumps, problem.seed);
  if (joins == 0) return 0;
  fill_capacities(mesh, spacing, normals_round(surface, stumps.cap, loose), job.threads(), problem);
  ContractedCut contracted = contract(mesh, problem, job);
  const MinCut minimum = max_flow(std::move(contracted.graph), job);
  labels = scatter(problem.seed, contracted.tetrahedron, minimum.source_side);
  return joins;
}

}  // namespace arris
