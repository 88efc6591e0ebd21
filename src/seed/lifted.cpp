#include "seed/lifted.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "base/vec.h"
#include "seed/shapes.h"
#include "tetra/locate.h"

namespace arris {
namespace {

// The bulge, in units of spacing: tetrahedra lower and shorter than this, whose base leans from the
// surface by less than this cosine says.
constexpr double bulge_height = 0.2, bulge_length = 4, along_surface = 0.9;
// Where faces are flat but for noise, the label of a tetrahedron as low as this is chance.
constexpr double flat_height = 0.03;

// Unit normal of the largest facet.
Vec3 base_normal(const TetMesh& mesh, Tet t) {
  Vec3 best;
  for (const auto& facet : facet_corners) {
    std::array<Vec3, 3> x;
    for (std::size_t k = 0; k < 3; ++k)
      x[k] = mesh.points[mesh.vertices[t][static_cast<std::size_t>(facet[k])]];
    const Vec3 n = cross(x[1] - x[0], x[2] - x[0]);
    if (squared_length(n) > squared_length(best)) best = n;
  }
  const double twice_area = length(best);
  return twice_area > 0 ? (1 / twice_area) * best : best;
}

class Labeller {
 public:
  Labeller(const TetMesh& coarse, const Labels& labels, const TetMesh& fine,
           const std::vector<Tet>& former, const std::vector<LiftedPoint>& lifted,
           const std::vector<double>& spacing)
      : coarse_(coarse),
        labels_(labels),
        fine_(fine),
        former_(former),
        lifted_(lifted),
        spacing_(spacing),
        entry_(star_seeds(coarse)) {}

  void label(Tet t, Seeds& seeds) const {
    if (former_[t] != no_tet) {
      seeds.label[t] = labels_[former_[t]];
      seeds.firm[t] = 1;
      return;
    }
    const double h = mean_spacing(fine_, spacing_, t);
    const TetBase base = largest_base(fine_, t);
    const Circumball ball = circumball(fine_, t);
    if (base.height < bulge_height * h && longest_edge(fine_, t) < bulge_length * h &&
        label_in_bulge(t, ball, seeds.label[t])) {
      seeds.firm[t] = ball.radius > firm_radius * h;
      return;
    }
    const bool bridge = is_bridge(fine_, t, base, h);
    seeds.label[t] = bridge ? seed_free : label_below(fine_.vertices[t]);
    seeds.hint[t] = base.height < flat_height * h;
    seeds.firm[t] = !bridge && !seeds.hint[t] && ball.radius > firm_radius * h;
  }

 private:
  const LiftedPoint* lifted(Index v) const {
    return v < coarse_.points.size() ? nullptr : &lifted_[v - coarse_.points.size()];
  }

  // False if t has no lifted corner on one surface, or does not lie along it.
  bool label_in_bulge(Tet t, const Circumball& ball, Seed& label) const {
    const Vec3 base = base_normal(fine_, t);
    double above = 0;
    bool found = false;
    for (Index v : fine_.vertices[t]) {
      const LiftedPoint* p = lifted(v);
      if (p == nullptr || p->normals.size() != 1) continue;
      if (std::abs(dot(base, p->normals[0])) <= along_surface) return false;
      above += dot(p->normals[0], ball.centre - fine_.points[v]);
      found = true;
    }
    if (found) label = above < 0 ? seed_inside : seed_outside;
    return found;
  }

  // What `coarse` has where the centroid of these corners would be without the lift.
  Seed label_below(const std::array<Index, 4>& corners) const {
    Vec3 middle;
    for (Index v : corners) {
      const LiftedPoint* p = lifted(v);
      middle = middle + 0.25 * (p ? p->foot : fine_.points[v]);
    }
    const Index first = *std::min_element(corners.begin(), corners.end());
    const LiftedPoint* p = lifted(first);
    return labels_[locate(coarse_, middle, entry_[p ? p->near : first])];
  }

  const TetMesh& coarse_;
  const Labels& labels_;
  const TetMesh& fine_;
  const std::vector<Tet>& former_;
  const std::vector<LiftedPoint>& lifted_;
  const std::vector<double>& spacing_;
  std::vector<Tet> entry_;
};

}  // namespace

Seeds lifted_seeds(const TetMesh& coarse, const Labels& labels, const Seeds& seeds,
                   const TetMesh& fine, const std::vector<Tet>& former,
                   const std::vector<LiftedPoint>& lifted, const std::vector<double>& spacing,
                   Job& job) {
  job.tick(0);
  const Labeller labeller(coarse, labels, fine, former, lifted, spacing);
  Seeds result;
  result.contradiction = seeds.contradiction;
  result.confidence = seeds.confidence;
  result.label.resize(fine.finite);
  result.firm.assign(fine.finite, 0);
  result.hint.assign(fine.finite, 0);
  parallel_for(fine.finite, job.threads(),
               [&](std::size_t t) { labeller.label(static_cast<Tet>(t), result); });
  return result;
}

}  // namespace arris
