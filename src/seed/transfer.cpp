#include "seed/transfer.h"

#include <algorithm>
#include <array>

#include "base/parallel.h"
#include "seed/shapes.h"
#include "tetra/locate.h"

namespace arris {
namespace {

Circumball ball_of(const TetMesh& mesh, Tet t) {
  const auto& v = mesh.vertices[t];
  return circumball(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
}

// The tetrahedra that were not there before, and those beyond their facets.
std::vector<std::uint8_t> round_new(const TetMesh& fine, const std::vector<Tet>& former,
                                    unsigned threads) {
  const auto is_new = [&](Tet t) { return fine.is_finite(t) && former[t] == no_tet; };
  std::vector<std::uint8_t> marked(fine.finite);
  parallel_for(fine.finite, threads, [&](std::size_t i) {
    const auto t = static_cast<Tet>(i);
    const auto& beyond = fine.neighbours[t];
    marked[t] = is_new(t) || std::any_of(beyond.begin(), beyond.end(), is_new);
  });
  return marked;
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
                   const std::vector<std::uint8_t>& settled, Job& job) {
  job.tick(0);
  const std::vector<Tet> star = star_seeds(coarse);
  Seeds result;
  result.contradiction = seeds.contradiction;
  result.confidence = seeds.confidence;
  result.label.resize(fine.finite);
  result.firm.resize(fine.finite);
  // What the points were added to correct must not vote against them, unless it is firm.
  result.hint = round_new(fine, former, job.threads());
  const auto label_at = [&](Tet t) {
    if (former[t] != no_tet) return labels[former[t]];
    const auto& corners = fine.vertices[t];
    const Index v = *std::min_element(corners.begin(), corners.end());
    const Index known = v < coarse.points.size() ? v : near[v - coarse.points.size()];
    return labels[locate(coarse, centroid(fine, t), star[known])];
  };
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
    if (sliver) result.hint[t] = 1;
    const bool bridge = is_bridge(fine, t, base, h);
    result.label[t] = bridge ? seed_free : label_at(t);
    result.firm[t] = !bridge && !sliver && ball_of(fine, t).radius > firm_radius * h;
  });
  return result;
}

}  // namespace arris
