#include "cut/surface_cut.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "base/vec.h"
#include "cut/facet_costs.h"
#include "energy/facet.h"
#include "support/known_solids.h"
#include "support/random.h"

namespace arris {
namespace {

using namespace test;

SurfaceCut cut(const TetMesh& mesh, const EnergyModel& model, const Seeds& seeds,
               const std::vector<double>& curvature = {}) {
  OneStageJob job;
  return cut_surface(mesh, model, seeds, curvature, job);
}

std::vector<double> some_curvature(std::size_t n, Random& random) {
  std::vector<double> curvature(n);
  for (double& k : curvature) k = 4 * random.unit() - 2;
  return curvature;
}

TEST(SurfaceCut, EnergyIsThatOfItsSurfaceAndFirmSeedsKeepTheirLabel) {
  Random random(1);
  for (const KnownSolid& solid : known_solids(1000)) {
    SCOPED_TRACE(solid.name);
    const Measured m(solid.samples);
    OneStageJob job;
    const Seeds seeds = find_seeds(m.mesh, m.stars, m.balls, m.spacing, job);
    const EnergyModel model{0.1, Curvature::polyhedral, m.spacing};
    for (const auto& curvature : {std::vector<double>{}, some_curvature(1000, random)}) {
      if (!curvature.empty() && m.mesh.points.size() > curvature.size()) continue;
      const SurfaceCut c = cut(m.mesh, model, seeds, curvature);
      EXPECT_EQ(c.energy, surface_cost(m.mesh, model, curvature, c.labels));
      EXPECT_GT(c.energy, 0);
      std::uint64_t free = 0;
      for (Tet t = 0; t < m.mesh.finite; ++t) {
        const bool firm = seeds.label[t] != seed_free && seeds.firm[t];
        free += !firm;
        if (firm) {
          EXPECT_EQ(c.labels[t], seeds.label[t]);
        }
      }
      EXPECT_EQ(c.free, free);
      for (std::size_t t = m.mesh.finite; t < m.mesh.size(); ++t) EXPECT_EQ(c.labels[t], 0);
    }
  }
}

TEST(SurfaceCut, ClearTetrahedraComeOutRight) {
  for (const KnownSolid& solid : known_solids(2000)) {
    const Measured m(solid.samples);
    OneStageJob job;
    const Seeds seeds = find_seeds(m.mesh, m.stars, m.balls, m.spacing, job);
    const SurfaceCut c = cut(m.mesh, {0.1, Curvature::polyhedral, m.spacing}, seeds);
    for (Tet t = 0; t < m.mesh.finite; ++t) {
      const double d = solid.distance(centroid_of(m.mesh, t));
      if (std::abs(d) < 0.25 * mean_spacing(m.mesh, m.spacing, t)) continue;
      EXPECT_EQ(c.labels[t], d < 0) << solid.name << " " << d;
    }
  }
}

// The least cost of a surface over all labels of the free tetrahedra.
double least_cost(const TetMesh& mesh, const EnergyModel& model,
                  const std::vector<double>& curvature, Labels labels,
                  const std::vector<Tet>& free) {
  double best = std::numeric_limits<double>::infinity();
  for (std::uint32_t pattern = 0; pattern < 1u << free.size(); ++pattern) {
    for (std::size_t k = 0; k < free.size(); ++k)
      labels[free[k]] = static_cast<std::uint8_t>(pattern >> k & 1u);
    best = std::min(best, surface_cost(mesh, model, curvature, labels));
  }
  return best;
}

RC_GTEST_PROP(SurfaceCut, IsTheCheapestOfAllSurfaces, (std::uint64_t seed)) {
  Random random(seed);
  std::vector<Vec3> points(20);
  for (Vec3& p : points) p = {random.unit(), random.unit(), random.unit()};
  const Measured m(points);
  const EnergyModel model{0.5, Curvature::cotangent, m.spacing};
  const std::vector<double> curvature = some_curvature(points.size(), random);
  Seeds seeds;
  Labels labels(m.mesh.size(), 0);
  std::vector<Tet> free;
  for (Tet t = 0; t < m.mesh.finite; ++t) {
    labels[t] = static_cast<std::uint8_t>(random.below(2));
    const bool decided = free.size() == 8 || random.below(4) != 0;
    seeds.label.push_back(decided ? labels[t] : seed_free);
    seeds.firm.push_back(decided);
    if (!decided) free.push_back(t);
  }
  const SurfaceCut c = cut(m.mesh, model, seeds, curvature);
  const double least = least_cost(m.mesh, model, curvature, labels, free);
  RC_ASSERT(c.free == free.size());
  RC_ASSERT(c.energy >= least * (1 - 1e-12));
  // Capacities are whole numbers of a millionth each; one rounding a facet.
  RC_ASSERT(c.energy <= least * (1 + 1e-12) + 4e-6 * 4 * static_cast<double>(free.size()));
}

TEST(FacetCost, AreaWeighsAreaAndNoCurvature) {
  const Measured m(known_solids(500)[2].samples);
  Random random(2);
  const std::vector<double> curvature = some_curvature(m.mesh.points.size(), random);
  const EnergyModel area{0.1, Curvature::area, m.spacing}, none{0, Curvature::area, m.spacing};
  for (Tet t = 0; t < m.mesh.finite; ++t)
    for (int i = 0; i < 4; ++i) {
      double h = 0;
      for (int corner : facet_corners[static_cast<std::size_t>(i)])
        h += m.spacing[m.mesh.vertices[t][static_cast<std::size_t>(corner)]] / 3;
      const double s = 0.5 * length(facet_normal(m.mesh, t, i));
      const double cost = facet_cost(m.mesh, area, curvature, t, i);
      EXPECT_NEAR(cost - facet_cost(m.mesh, none, {}, t, i), 0.1 * s / (h * h), 1e-9 * cost);
    }
}

TEST(FacetCost, IsTheSameFromBothSides) {
  const Measured m(known_solids(500)[2].samples);
  const EnergyModel model{0.1, Curvature::polyhedral, m.spacing};
  Random random(2);
  const std::vector<double> curvature = some_curvature(m.mesh.points.size(), random);
  for (Tet t = 0; t < m.mesh.size(); ++t)
    for (std::size_t i = 0; i < 4; ++i) {
      const Tet n = m.mesh.neighbours[t][i];
      const double cost = facet_cost(m.mesh, model, curvature, t, static_cast<int>(i));
      EXPECT_EQ(cost, facet_cost(m.mesh, model, curvature, n, m.mesh.facet_to(n, t)));
      if (m.mesh.is_finite(t)) {
        EXPECT_GT(cost, 0);
      }
      if (!m.mesh.is_finite(t) && !m.mesh.is_finite(n)) {
        EXPECT_EQ(cost, 0);
      }
    }
}

}  // namespace
}  // namespace arris
