#include "seed/transfer.h"

#include <algorithm>
#include <array>

#include "base/parallel.h"
#include "seed/shapes.h"
#include "tetra/locate.h"

namespace arris {
namespace {

// Per tetrahedron the labels of the places (bit l for label l) where those of its corners lie that
// were added, or those of the tetrahedron beyond a facet. `place`: the labels of the added points.
std::vector<std::uint8_t> places_round(const TetMesh& fine, const std::vector<std::uint8_t>& place,
                                       unsigned threads) {
  const std::size_t known = fine.points.size() - place.size();
  std::vector<std::uint8_t> at(fine.size(), 0), round(fine.finite);
  parallel_for(fine.finite, threads, [&](std::size_t t) {
    for (Index v : fine.vertices[t])
      if (v >= known) at[t] = static_cast<std::uint8_t>(at[t] | 1 << place[v - known]);
  });
  parallel_for(fine.finite, threads, [&](std::size_t t) {
    round[t] = at[t];
    for (Tet n : fine.neighbours[t]) round[t] = static_cast<std::uint8_t>(round[t] | at[n]);
  });
  return round;
}

// A tetrahedron at a point of more than this many can be so long that a walk from one of its
// corners to its centroid crosses very many others.
constexpr Index most_round = 256;

std::vector<std::uint8_t> points_of_many(const TetMesh& mesh) {
  std::vector<Index> degree(mesh.points.size(), 0);
  for (const auto& corners : mesh.vertices)
    for (Index v : corners)
      if (v != infinite_vertex) ++degree[v];
  std::vector<std::uint8_t> many(degree.size());
  for (std::size_t v = 0; v < many.size(); ++v) many[v] = degree[v] > most_round;
  return many;
}

// Where in the coarse mesh the centroids of the `wanted` tetrahedra lie; no_tet for others. One
// after the other, from neighbour to neighbour, so that each walk begins near its end; `start[t]`
// is where the first of each connected group begins.
template <class Start>
std::vector<Tet> locate_in_turn(const TetMesh& coarse, const TetMesh& fine,
                                const std::vector<std::uint8_t>& wanted, Start&& start, Job& job) {
  std::vector<Tet> place(fine.finite, no_tet), stack;
  std::size_t done = 0;
  const auto visit = [&](Tet t, Tet from) {
    if (done++ % 4096 == 0) job.tick(0);
    place[t] = locate(coarse, centroid(fine, t), from);
    stack.push_back(t);
  };
  for (Tet first = 0; first < fine.finite; ++first) {
    if (!wanted[first] || place[first] != no_tet) continue;
    visit(first, start(first));
    while (!stack.empty()) {
      const Tet t = stack.back();
      stack.pop_back();
      for (Tet n : fine.neighbours[t])
        if (fine.is_finite(n) && wanted[n] && place[n] == no_tet) visit(n, place[t]);
    }
  }
  return place;
}

}  // namespace

Seeds transfer_seeds(const TetMesh& coarse, const Labels& labels, const Seeds& seeds,
                     const TetMesh& fine, Job& job) {
  job.tick(0);
  const std::vector<Tet> near = star_seeds(coarse);
  const auto label_at = [&](Vec3 p, Index nearest) {
    return labels[locate(coarse, p, near[nearest])];
  };
  std::vector<std::uint8_t> added(fine.points.size() - fine.samples);
  parallel_for(added.size(), job.threads(), [&](std::size_t k) {
    const auto v = static_cast<Index>(fine.samples + k);
    added[k] = label_at(fine.points[v], fine.nearest_sample(v));
  });
  Seeds result;
  result.contradiction = seeds.contradiction;
  result.confidence = seeds.confidence;
  result.label.resize(fine.finite);
  result.firm.resize(fine.finite);
  parallel_for(fine.finite, job.threads(), [&](std::size_t t) {
    const auto& corners = fine.vertices[t];
    std::array<int, 2> votes = {0, 0};
    for (Index v : corners)
      if (!fine.is_sample(v)) ++votes[added[v - fine.samples]];
    result.firm[t] = (votes[0] > 0) != (votes[1] > 0);
    result.label[t] = result.firm[t] ? votes[1] > 0
                                     : label_at(centroid(fine, static_cast<Tet>(t)),
                                                fine.nearest_sample(corners[0]));
  });
  return result;
}

Seeds follow_seeds(const TetMesh& coarse, const Labels& labels, const Seeds& seeds,
                   const TetMesh& fine, const std::vector<Tet>& former,
                   const std::vector<Index>& near, const std::vector<double>& spacing,
                   const std::vector<std::uint8_t>& settled, const std::vector<Seed>& told,
                   Job& job) {
  job.tick(0);
  const std::vector<Tet> star = star_seeds(coarse);
  const std::vector<std::uint8_t> many = points_of_many(fine);
  const auto star_round = [&](Tet t) {
    const auto& corners = fine.vertices[t];
    const Index v = *std::min_element(corners.begin(), corners.end());
    return star[v < coarse.points.size() ? v : near[v - coarse.points.size()]];
  };
  std::vector<std::uint8_t> long_way(fine.finite);
  parallel_for(fine.finite, job.threads(), [&](std::size_t t) {
    const auto& corners = fine.vertices[t];
    long_way[t] = former[t] == no_tet && std::any_of(corners.begin(), corners.end(),
                                                     [&](Index v) { return many[v] != 0; });
  });
  const std::vector<Tet> located = locate_in_turn(coarse, fine, long_way, star_round, job);
  Seeds result;
  result.contradiction = seeds.contradiction;
  result.confidence = seeds.confidence;
  result.label.resize(fine.finite);
  result.firm.resize(fine.finite);
  result.hint.assign(fine.finite, 0);
  const auto label_at = [&](Tet t) {
    if (former[t] != no_tet) return labels[former[t]];
    if (located[t] != no_tet) return labels[located[t]];
    return labels[locate(coarse, centroid(fine, t), star_round(t))];
  };
  std::vector<std::uint8_t> place(near.size());
  parallel_for(near.size(), job.threads(), [&](std::size_t k) {
    place[k] = labels[locate(coarse, fine.points[coarse.points.size() + k], star[near[k]])];
  });
  const std::vector<std::uint8_t> places = places_round(fine, place, job.threads());
  parallel_for(fine.finite, job.threads(), [&](std::size_t i) {
    const auto t = static_cast<Tet>(i);
    const double h = mean_spacing(fine, spacing, t);
    const TetBase base = settled[t] ? TetBase{} : largest_base(fine, t);
    const bool sliver = base.height < sliver_height * h;
    // A sliver that was there before keeps its label for good. What holds the centroid of a new one
    // is chance: it may only break ties, or a stack of them would fold the surface over a face.
    if (settled[t] || (sliver && former[t] != no_tet)) {
      result.label[t] = labels[former[t]];
      result.firm[t] = 1;
      return;
    }
    if (!sliver && told[t] != seed_free) {
      result.label[t] = told[t];
      result.firm[t] = 1;
      return;
    }
    if (is_bridge(fine, t, base, h)) {
      result.label[t] = seed_free;
      return;
    }
    const std::uint8_t label = label_at(t);
    result.label[t] = label;
    // A point that lies outside was added to win what is outside round it: that must not vote
    // against it, and likewise inside.
    result.hint[t] = sliver || (places[t] >> label & 1) != 0;
    result.firm[t] = !sliver && circumball(fine, t).radius > firm_radius * h;
  });
  return result;
}

}  // namespace arris
