#include "energy/curvature.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <numbers>

#include "energy/distance.h"
#include "swap/labelling.h"
#include "swap/solids.h"
#include "tetra/delaunay.h"

namespace arris {
namespace {

constexpr double pi = std::numbers::pi;

TetMesh build(const std::vector<Vec3>& points) {
  const Context context;
  Job job(context);
  job.stage("delaunay", 1);
  return delaunay(points, points.size(), job);
}

EnergyModel model_of(const TetMesh& mesh, double h, Curvature kind) {
  EnergyModel model;
  model.curvature = kind;
  model.spacing.assign(mesh.points.size(), h);
  return model;
}

TEST(Polyhedral, KnownTotals) {
  for (const test::Solid& solid :
       {test::cube(0.1), test::two_cubes(0.1), test::octahedron(0.1), test::l_prism(0.1)}) {
    const TetMesh mesh = build(solid.samples);
    const double total = total_mean_curvature(mesh, test::centroid_labels(mesh, solid));
    EXPECT_NEAR(total / solid.curvature, 1, 1e-9) << solid.name;
  }
}

TEST(Polyhedral, ApproachesSmoothTotals) {
  for (const test::Solid& solid : {test::ball(0.1), test::cylinder(0.1)}) {
    const TetMesh mesh = build(solid.samples);
    const double total = total_mean_curvature(mesh, test::centroid_labels(mesh, solid));
    EXPECT_NEAR(total / solid.curvature, 1, 0.002) << solid.name;
  }
}

// By the definition: the sum of the dihedral angles of the inside tetrahedra round each edge.
RC_GTEST_PROP(Polyhedral, AgreesWithSumsOfDihedralAngles, ()) {
  const auto seed = *rc::gen::inRange(0u, 1000000u);
  test::Solid solid = test::bumpy_ball(200, seed);
  const TetMesh mesh = build(solid.samples);
  Labels labels = test::grow_ball(mesh, solid);
  test::disturb(mesh, 60, seed, labels);
  std::map<std::pair<Index, Index>, std::pair<double, bool>> edges;  // inside angle, on surface
  for (Tet t = 0; t < mesh.finite; ++t) {
    const auto& c = mesh.vertices[t];
    for (std::size_t e = 0; e < 6; ++e) {
      const auto [p, q] = edge_corners[e];
      const auto [r, s] = edge_corners[5 - e];
      const auto at = [&](int k) { return mesh.points[c[static_cast<std::size_t>(k)]]; };
      const Vec3 axis = at(q) - at(p), u = cross(axis, at(r) - at(p)),
                 v = cross(axis, at(s) - at(p));
      auto& [angle, surface] =
          edges[std::minmax(c[static_cast<std::size_t>(p)], c[static_cast<std::size_t>(q)])];
      if (labels[t] != 0) angle += std::atan2(length(cross(u, v)), dot(u, v));
      for (int f : {r, s})
        surface |= labels[mesh.neighbours[t][static_cast<std::size_t>(f)]] != labels[t];
    }
  }
  double total = 0;
  for (const auto& [edge, state] : edges)
    if (state.second)
      total += 0.5 * distance(mesh.points[edge.first], mesh.points[edge.second]) *
               std::abs(pi - state.first);
  RC_ASSERT(std::abs(total_mean_curvature(mesh, labels) / total - 1) < 1e-9);
  const EnergyModel model = model_of(mesh, 0.5, Curvature::polyhedral);
  RC_ASSERT(std::abs(polyhedral_energy(mesh, model, labels) / (0.1 * total / 0.5) - 1) < 1e-9);
}

TEST(Cotangent, IsOneOverTheRadiusOnASphere) {
  test::Solid solid = test::ball(0.05);
  for (Vec3& p : solid.samples) p = 3.0 * p;
  const TetMesh mesh = build(solid.samples);
  const Labels labels(mesh.size(), 1);  // convex: everything finite is inside
  Labels inside = labels;
  for (Tet t = static_cast<Tet>(mesh.finite); t < mesh.size(); ++t) inside[t] = 0;
  const double h = 0.15;
  const EnergyModel model = model_of(mesh, h, Curvature::cotangent);
  // λ ∫ |κ| ds / h = λ (1/3) (4 pi 9) / h
  EXPECT_NEAR(cotangent_energy(mesh, model, inside) / (0.1 * 12 * pi / h), 1, 0.01);
}

TEST(Cotangent, AFlatFanHasNone) {
  // The corner terms of a square fan about its centre cancel.
  const std::vector<Vec3> points = {{0, 0, 0},  {1, 0, 0},  {0, 1, 0},
                                    {-1, 0, 0}, {0, -1, 0}, {0.1, 0.2, -1}};
  const TetMesh mesh = build(points);
  const EnergyModel model = model_of(mesh, 1, Curvature::cotangent);
  VertexCurvature sum;
  for (Tet t = 0; t < mesh.finite; ++t)
    for (int i = 0; i < 4; ++i) {
      if (mesh.vertices[t][static_cast<std::size_t>(i)] != 5) continue;  // the facet in z = 0
      const auto terms = facet_curvature(mesh, model, t, i);
      for (std::size_t k = 0; k < 3; ++k) {
        const int corner = facet_corners[static_cast<std::size_t>(i)][k];
        if (mesh.vertices[t][static_cast<std::size_t>(corner)] == 0) sum += terms[k];
      }
    }
  EXPECT_NEAR(sum.area, 1, 1e-12);  // half of the square, whose triangles are right-angled there
  EXPECT_NEAR(sum.weight, 2.0 / 3, 1e-12);
  EXPECT_NEAR(sum.mean_curvature(), 0, 1e-12);
}

// Any two facets of one tetrahedron over random points: the mean distance against dense sampling.
RC_GTEST_PROP(FacetDistance, AgreesWithDenseSampling, ()) {
  std::mt19937_64 random(*rc::gen::inRange(0u, 1000000u));
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Vec3> points(30);
  for (Vec3& p : points) p = {unit(random), unit(random), 0.1 * unit(random)};
  const TetMesh mesh = build(points);
  for (Tet t = 0; t < mesh.finite; ++t)
    for (int i = 0; i < 4; ++i) {
      std::vector<Vec3> samples, x;
      for (Index v : mesh.vertices[t]) samples.push_back(mesh.points[v]);
      const Tet n = mesh.neighbours[t][static_cast<std::size_t>(i)];
      const Index apex = mesh.vertices[n][static_cast<std::size_t>(mesh.facet_to(n, t))];
      if (apex != infinite_vertex) samples.push_back(mesh.points[apex]);
      for (int c : facet_corners[static_cast<std::size_t>(i)])
        x.push_back(samples[static_cast<std::size_t>(c)]);
      constexpr int parts = 40;
      double sum = 0;
      const auto add = [&](double a, double b) {
        const Vec3 p = x[0] + a / parts * (x[1] - x[0]) + b / parts * (x[2] - x[0]);
        double nearest = 1e300;
        for (Vec3 s : samples) nearest = std::min(nearest, distance(p, s));
        sum += nearest;
      };
      for (int a = 0; a < parts; ++a)
        for (int b = 0; a + b < parts; ++b) {
          add(a + 1.0 / 3, b + 1.0 / 3);
          if (a + b + 1 < parts) add(a + 2.0 / 3, b + 2.0 / 3);
        }
      const double mean = sum / (parts * parts);
      RC_ASSERT(std::abs(facet_distance(mesh, t, i).mean_distance / mean - 1) < 0.02);
    }
}

}  // namespace
}  // namespace arris
