// What a facet pays for leaning from the sides that are known at its corners.
#include <gtest/gtest.h>

#include <cmath>

#include "energy/facet.h"
#include "support/tetra.h"

namespace arris {
namespace {

using namespace test;

// One tetrahedron: facet 3 lies in the plane z = 0.
const std::vector<Vec3> corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

EnergyModel model_with(const TetMesh& mesh, const std::vector<Vec3>& sides) {
  EnergyModel model;
  model.spacing.assign(mesh.points.size(), 2);
  model.sides.first.push_back(0);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    model.sides.normal.insert(model.sides.normal.end(), sides.begin(), sides.end());
    model.sides.first.push_back(static_cast<Index>(model.sides.normal.size()));
  }
  return model;
}

// What the facet in z = 0 costs more than without sides, over its area in squares of spacing.
double surcharge(const std::vector<Vec3>& sides) {
  const TetMesh mesh = delaunay_of(corner);
  const EnergyModel with = model_with(mesh, sides);
  EnergyModel without = with;
  without.sides = {};
  for (int i = 0; i < 4; ++i) {
    const Vec3 n = facet_normal(mesh, 0, i);
    if (n.x != 0 || n.y != 0) continue;
    return (fidelity_cost(mesh, with, 0, i) - fidelity_cost(mesh, without, 0, i)) / (0.5 / 4);
  }
  return -1;
}

TEST(Lean, AFacetInItsSidePaysNothing) {
  EXPECT_NEAR(surcharge({{0, 0, 1}}), 0, 1e-15);
  EXPECT_NEAR(surcharge({{1, 0, 0}, {0, 0, -1}}), 0, 1e-15);  // the nearest side counts
}

TEST(Lean, AFacetPaysTheSquaredSine) {
  EXPECT_NEAR(surcharge({{1, 0, 0}}), 1, 1e-15);
  for (double angle : {0.1, 0.5, 1.0})
    EXPECT_NEAR(surcharge({{std::sin(angle), 0, std::cos(angle)}}),
                std::sin(angle) * std::sin(angle), 1e-14);
}

TEST(Lean, CornersWithoutSidesHaveNoSay) {
  EXPECT_EQ(surcharge({}), 0);
}

// E must be a function of the labels to the last bit.
TEST(Lean, BothSidesOfAFacetSeeTheSameCost) {
  std::vector<Vec3> points = corner;
  points.push_back({1, 1, 1.25});
  points.push_back({0.25, -0.75, 0.5});
  const TetMesh mesh = delaunay_of(points);
  const EnergyModel model = model_with(mesh, {{0.6, 0, 0.8}, {0, 1, 0}});
  int shared = 0;
  for (Tet t = 0; t < mesh.finite; ++t)
    for (int i = 0; i < 4; ++i) {
      const Tet n = mesh.neighbours[t][static_cast<std::size_t>(i)];
      if (!mesh.is_finite(n)) continue;
      ++shared;
      EXPECT_EQ(fidelity_cost(mesh, model, t, i),
                fidelity_cost(mesh, model, n, mesh.facet_to(n, t)));
    }
  EXPECT_GT(shared, 0);
}

}  // namespace
}  // namespace arris
