#include "swap/boundary.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "swap/energy_change.h"
#include "swap/labelling.h"
#include "swap/swap.h"
#include "swap/topology.h"
#include "tetra/delaunay.h"

namespace arris {
namespace {

struct Scene {
  TetMesh mesh;
  EnergyModel model;
  Labels labels;
};

// Random points in a cube, and a ball of tetrahedra grown and disturbed in them.
Scene random_scene(unsigned seed, Curvature kind) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1), spacing(0.2, 0.6);
  Scene scene;
  std::vector<Vec3> points(40);
  for (Vec3& p : points) p = {unit(random), unit(random), unit(random)};
  const Context context;
  Job job(context);
  job.stage("delaunay", 1);
  scene.mesh = delaunay(points, points.size(), job);
  scene.model.curvature = kind;
  for (std::size_t k = 0; k < points.size(); ++k) scene.model.spacing.push_back(spacing(random));
  test::Solid solid;
  solid.inside = [](Vec3 p) { return squared_length(p) < 0.5; };
  scene.labels = test::grow_ball(scene.mesh, solid);
  test::disturb(scene.mesh, 20, seed, scene.labels);
  return scene;
}

RC_GTEST_PROP(Boundary, SimpleFlipsAndOnlyTheyKeepTheTopology, ()) {
  Scene scene = random_scene(*rc::gen::inRange(0u, 1000000u), Curvature::polyhedral);
  const test::Topology before = test::topology(scene.mesh, scene.labels);
  RC_PRE(!before.vertices.empty());
  RC_ASSERT(before.manifold);
  RC_ASSERT(before.euler == 2);
  Boundary boundary(scene.mesh, scene.labels);
  for (Tet t = 0; t < scene.mesh.finite; ++t) {
    const bool simple = boundary.is_simple(t);
    const Index removed = simple ? boundary.removed_vertex(t) : no_index;
    boundary.flip(t);
    const test::Topology after = test::topology(scene.mesh, scene.labels);
    RC_ASSERT(simple == (after.manifold && after.euler == 2));
    if (removed != no_index) RC_ASSERT(after.vertices.count(removed) == 0u);
    for (Index v = 0; v < scene.mesh.points.size(); ++v)
      RC_ASSERT(boundary.on_surface(v) == (after.vertices.count(v) == 1));
    boundary.flip(t);
  }
}

void check_changes(Curvature kind) {
  Scene scene = random_scene(*rc::gen::inRange(0u, 1000000u), kind);
  Boundary boundary(scene.mesh, scene.labels);
  const double before = total_energy(scene.mesh, scene.model, scene.labels);
  for (Tet t = 0; t < scene.mesh.finite; ++t) {
    if (!boundary.is_simple(t)) continue;
    const Change change =
        flip_change(boundary, scene.model, FidelityCosts(scene.mesh, scene.model), t);
    boundary.flip(t);
    const double after = total_energy(scene.mesh, scene.model, scene.labels);
    RC_ASSERT(std::abs(after - before - change.value) < 1e-11 * before);
    RC_ASSERT(
        std::abs(
            flip_change(boundary, scene.model, FidelityCosts(scene.mesh, scene.model), t).value +
            change.value) < 1e-11 * before);
    boundary.flip(t);
  }
}

RC_GTEST_PROP(FlipChange, AgreesWithTheWholePolyhedral, ()) {
  check_changes(Curvature::polyhedral);
}
RC_GTEST_PROP(FlipChange, AgreesWithTheWholeCotangent, ()) {
  check_changes(Curvature::cotangent);
}
RC_GTEST_PROP(FlipChange, AgreesWithTheWholeArea, ()) {
  check_changes(Curvature::area);
}

}  // namespace
}  // namespace arris
