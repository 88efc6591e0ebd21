#include "seed/transfer.h"

#include <algorithm>
#include <array>

#include "base/parallel.h"
#include "seed/shapes.h"
#include "tetra/locate.h"

namespace arris {

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

Seeds follow_seeds(const TetMesh& coarse, const Stars& stars, const Labels& labels,
                   const Seeds& seeds, const TetMesh& fine, const std::vector<Index>& near,
                   const std::vector<double>& spacing, Job& job) {
  job.tick(0);
  const std::vector<Tet> star = star_seeds(coarse);
  const std::vector<Circumball> balls = circumballs(fine, job.threads());
  Seeds result;
  result.contradiction = seeds.contradiction;
  result.confidence = seeds.confidence;
  result.label.resize(fine.finite);
  result.firm.resize(fine.finite);
  result.hint.assign(fine.finite, 0);
  parallel_for(fine.finite, job.threads(), [&](std::size_t i) {
    const auto t = static_cast<Tet>(i);
    const auto& corners = fine.vertices[t];
    const Index v = *std::min_element(corners.begin(), corners.end());
    const Index known = v < coarse.points.size() ? v : near[v - coarse.points.size()];
    const double h = mean_spacing(fine, spacing, t);
    const TetBase base = largest_base(fine, t);
    if (base.height < sliver_height * h) {
      // One that was there before keeps its label for good. What holds the centroid of a new one is
      // chance: it may only break ties, or a stack of them would fold the surface over a face.
      const Tet same = find_tet(coarse, stars, corners);
      if (same != no_tet) {
        result.label[t] = labels[same];
        result.firm[t] = 1;
        return;
      }
      result.hint[t] = 1;
    }
    const bool bridge = is_bridge(fine, t, base, h);
    result.label[t] = bridge ? seed_free : labels[locate(coarse, centroid(fine, t), star[known])];
    result.firm[t] = !bridge && !result.hint[t] && balls[t].radius > firm_radius * h;
  });
  return result;
}

}  // namespace arris
