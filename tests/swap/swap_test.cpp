#include "swap/swap.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <atomic>

#include "base/failure.h"
#include "energy/curvature.h"
#include "swap/boundary.h"
#include "swap/energy_change.h"
#include "swap/labelling.h"
#include "swap/topology.h"
#include "tetra/delaunay.h"

namespace arris {
namespace {

struct Scene {
  TetMesh mesh;
  EnergyModel model;
  Labels truth, labels;
};

// The solid, disturbed by one random simple flip for every `one_in` samples.
Scene make_scene(const test::Solid& solid, Curvature kind, std::size_t one_in, unsigned seed = 7) {
  const Context context;
  Job job(context);
  job.stage("delaunay", 1);
  Scene scene;
  scene.mesh = delaunay(solid.samples, solid.samples.size(), job);
  scene.model.curvature = kind;
  scene.model.spacing.assign(solid.samples.size(), solid.spacing);
  scene.truth = test::centroid_labels(scene.mesh, solid);  // manifold for these solids: checked
  scene.labels = scene.truth;
  test::disturb(scene.mesh, solid.samples.size() / one_in, seed, scene.labels);
  return scene;
}

SwapResult run(const Scene& scene, Labels& labels, const SwapOptions& options = {},
               const std::atomic<bool>* cancel = nullptr, unsigned threads = 0) {
  Context context;
  context.cancel = cancel;
  context.threads = threads;
  Job job(context);
  job.stage("swap", 1);
  return swap_tetrahedra(scene.mesh, scene.model, options, labels, job);
}

// Runs, checks everything that is promised for every input, and returns the total mean curvature
// reached over the true one.
double checked_run(const test::Solid& solid, Curvature kind, std::size_t one_in) {
  const Scene scene = make_scene(solid, kind, one_in);
  Labels labels = scene.labels;
  const SwapResult result = run(scene, labels);
  EXPECT_DOUBLE_EQ(result.energy.front(), total_energy(scene.mesh, scene.model, scene.labels));
  for (std::size_t k = 1; k < result.energy.size(); ++k)
    EXPECT_LE(result.energy[k], result.energy[k - 1]);
  const double reached = total_energy(scene.mesh, scene.model, labels);
  EXPECT_NEAR(result.energy.back() / reached, 1, 1e-12);
  EXPECT_GE(result.flipped, result.accepted);
  const test::Topology before = test::topology(scene.mesh, scene.labels);
  const test::Topology after = test::topology(scene.mesh, labels);
  EXPECT_TRUE(before.manifold);
  EXPECT_TRUE(after.manifold);
  EXPECT_EQ(before.euler, after.euler);
  for (Index v : before.vertices) EXPECT_EQ(after.vertices.count(v), 1u);  // all are samples
  const double truth = total_energy(scene.mesh, scene.model, scene.truth);
  const double curvature = total_mean_curvature(scene.mesh, labels) / solid.curvature;
  std::printf(
      "%-10s %-10s 1/%zu: E %.4f of that of the solid (at first %.4f), curvature %.4f "
      "(at first %.4f)\n",
      solid.name.c_str(), kind == Curvature::cotangent ? "cotangent" : "polyhedral", one_in,
      reached / truth, result.energy.front() / truth, curvature,
      total_mean_curvature(scene.mesh, scene.labels) / solid.curvature);
  return curvature;
}

TEST(Swap, PolyhedralFindsSolidsWithFeatures) {
  for (const test::Solid& solid :
       {test::cube(0.1), test::two_cubes(0.1), test::octahedron(0.1), test::l_prism(0.1)})
    EXPECT_NEAR(checked_run(solid, Curvature::polyhedral, 10), 1, 1e-6) << solid.name;
}

TEST(Swap, PolyhedralApproachesSmoothSolids) {
  EXPECT_LT(checked_run(test::ball(0.1), Curvature::polyhedral, 10), 1.005);
  EXPECT_LT(checked_run(test::cylinder(0.1), Curvature::polyhedral, 10), 1.07);
}

TEST(Swap, CotangentFindsSolidsWithFeatures) {
  for (const test::Solid& solid :
       {test::cube(0.1), test::two_cubes(0.1), test::octahedron(0.1), test::l_prism(0.1)})
    EXPECT_LT(checked_run(solid, Curvature::cotangent, 10), 1.02) << solid.name;
}

// Half as many wrong flips as samples: far more than a cut leaves.
TEST(Swap, WithstandsHeavyDisturbance) {
  EXPECT_LT(checked_run(test::cube(0.1), Curvature::polyhedral, 2), 1.01);
  EXPECT_LT(checked_run(test::octahedron(0.1), Curvature::polyhedral, 2), 1.01);
  EXPECT_LT(checked_run(test::ball(0.1), Curvature::polyhedral, 2), 1.01);
  EXPECT_LT(checked_run(test::two_cubes(0.1), Curvature::polyhedral, 2), 1.3);
}

TEST(Swap, MayDropSamplesIfAllowed) {
  const test::Solid solid = test::ball(0.3);
  Scene scene = make_scene(solid, Curvature::polyhedral, 4);
  scene.model.lambda = 100;  // nothing but curvature matters: cutting off samples pays
  Labels kept = scene.labels, dropped = scene.labels;
  run(scene, kept);
  SwapOptions options;
  options.keep_samples = false;
  run(scene, dropped, options);
  const auto before = test::topology(scene.mesh, scene.labels).vertices;
  const auto after = test::topology(scene.mesh, kept).vertices;
  EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()));
  EXPECT_LT(test::topology(scene.mesh, dropped).vertices.size(), after.size());
  EXPECT_LE(total_energy(scene.mesh, scene.model, dropped),
            total_energy(scene.mesh, scene.model, kept));
}

double area(const TetMesh& mesh, const Labels& labels) {
  double sum = 0;
  for (Tet t = 0; t < mesh.finite; ++t)
    for (int i = 0; i < 4; ++i)
      if (labels[t] == 1 && labels[mesh.neighbours[t][static_cast<std::size_t>(i)]] == 0)
        sum += 0.5 * length(facet_normal(mesh, t, i));
  return sum;
}

// Area adds λ S / h^2 and nothing else; where samples may leave, its minimum cuts the edges off.
TEST(Swap, AreaIsWeighedByLambdaAndCutsEdgesOff) {
  const test::Solid solid = test::cube(0.1);
  Scene scene = make_scene(solid, Curvature::area, 10);
  EnergyModel distance = scene.model;
  distance.lambda = 0;
  const double h = solid.spacing;
  EXPECT_NEAR(total_energy(scene.mesh, scene.model, scene.labels) -
                  total_energy(scene.mesh, distance, scene.labels),
              scene.model.lambda * area(scene.mesh, scene.labels) / (h * h), 1e-9);
  Labels labels = scene.truth;
  SwapOptions options;
  options.keep_samples = false;
  run(scene, labels, options);
  EXPECT_LT(area(scene.mesh, labels), 0.99 * area(scene.mesh, scene.truth));
  const double cut_off = area(scene.mesh, labels);
  labels = scene.truth;
  run(scene, labels);  // they stay
  EXPECT_NEAR(area(scene.mesh, labels), area(scene.mesh, scene.truth), 1e-9);
  scene.model.curvature = Curvature::polyhedral;
  labels = scene.truth;
  run(scene, labels, options);
  EXPECT_LT(cut_off, area(scene.mesh, labels));
}

TEST(Swap, LeavesFrozenTetrahedraAlone) {
  const Scene scene = make_scene(test::cube(0.1), Curvature::polyhedral, 4);
  Labels labels = scene.labels;
  SwapOptions options;
  options.frozen.assign(scene.mesh.size(), 0);
  for (Tet t = 0; t < scene.mesh.finite; ++t)
    options.frozen[t] = test::centroid(scene.mesh, t).x < 0.5;
  run(scene, labels, options);
  std::size_t changed = 0;
  for (Tet t = 0; t < scene.mesh.size(); ++t) {
    const bool held = t >= scene.mesh.finite || options.frozen[t] != 0;
    const bool differs = labels[t] != scene.labels[t];
    ASSERT_FALSE(held && differs);
    changed += differs;
  }
  EXPECT_GT(changed, 0u);
}

// Settled ones are not looked at first: with all settled nothing moves, with half of them the other
// half does.
TEST(Swap, SettledTetrahedraWaitForAMoveBesideThem) {
  const Scene scene = make_scene(test::cube(0.1), Curvature::polyhedral, 4);
  SwapOptions options;
  options.settled.assign(scene.mesh.size(), 1);
  Labels labels = scene.labels;
  EXPECT_EQ(run(scene, labels, options).accepted, 0u);
  EXPECT_EQ(labels, scene.labels);
  for (Tet t = 0; t < scene.mesh.finite; ++t)
    options.settled[t] = test::centroid(scene.mesh, t).x < 0.5;
  const SwapResult half = run(scene, labels, options);
  Labels whole = scene.labels;
  const SwapResult all = run(scene, whole);
  EXPECT_GT(half.accepted, 0u);
  EXPECT_GT(half.energy.front() - half.energy.back(),
            0.25 * (all.energy.front() - all.energy.back()));
}

TEST(Swap, MakesTheSameMovesWithoutE) {
  const Scene scene = make_scene(test::cube(0.1), Curvature::polyhedral, 4);
  SwapOptions options;
  options.with_energy = false;
  Labels with = scene.labels, without = scene.labels;
  const SwapResult measured = run(scene, with), result = run(scene, without, options);
  EXPECT_EQ(without, with);
  EXPECT_GT(result.accepted, 0u);
  ASSERT_EQ(result.energy.size(), measured.energy.size());
  EXPECT_EQ(result.energy.front(), 0);
  EXPECT_NEAR(result.energy.back(), measured.energy.back() - measured.energy.front(), 1e-9);
}

TEST(Swap, IsDeterministicAndReachesAFixedPoint) {
  const Scene scene = make_scene(test::two_cubes(0.1), Curvature::polyhedral, 4);
  Labels first = scene.labels, second = scene.labels;
  const SwapResult result = run(scene, first);
  EXPECT_EQ(run(scene, second).energy, result.energy);
  EXPECT_EQ(first, second);
  Boundary boundary(scene.mesh, first);
  for (Tet t = 0; t < scene.mesh.finite; ++t)
    if (boundary.is_simple(t) && boundary.removed_vertex(t) == no_index) {
      EXPECT_FALSE(
          flip_change(boundary, scene.model, FidelityCosts(scene.mesh, scene.model), t).lowers());
    }
}

TEST(Swap, DoesNotDependOnThreads) {
  const Scene scene = make_scene(test::two_cubes(0.05), Curvature::polyhedral, 4);
  ASSERT_GT(scene.mesh.finite, 16'384u);  // several chunks of a parallel loop
  Labels one = scene.labels, two = scene.labels;
  EXPECT_EQ(run(scene, one, {}, nullptr, 1).energy, run(scene, two, {}, nullptr, 2).energy);
  EXPECT_EQ(one, two);
}

TEST(Swap, CanBeCancelled) {
  const Scene scene = make_scene(test::cube(0.2), Curvature::polyhedral, 4);
  Labels labels = scene.labels;
  const std::atomic<bool> cancel = true;
  try {
    run(scene, labels, {}, &cancel);
    FAIL();
  } catch (const Failure& f) {
    EXPECT_EQ(f.error().code, ErrorCode::cancelled);
  }
}

TEST(Swap, NothingInsideIsNothingToDo) {
  const Scene scene = make_scene(test::cube(0.3), Curvature::cotangent, 4);
  Labels labels(scene.mesh.size(), 0);
  const SwapResult result = run(scene, labels);
  EXPECT_EQ(result.accepted, 0u);
  EXPECT_EQ(result.energy.back(), 0);
}

RC_GTEST_PROP(Swap, KeepsItsPromisesOnBumpyBalls, ()) {
  const auto seed = *rc::gen::inRange(0u, 1000000u);
  const Curvature kind = *rc::gen::element(Curvature::polyhedral, Curvature::cotangent);
  const test::Solid solid = test::bumpy_ball(150, seed);
  Scene scene = make_scene(solid, kind, 2, seed);
  scene.labels = test::grow_ball(scene.mesh, solid);
  test::disturb(scene.mesh, 75, seed, scene.labels);
  Labels labels = scene.labels;
  const SwapResult result = run(scene, labels);
  const double reached = total_energy(scene.mesh, scene.model, labels);
  RC_ASSERT(std::abs(result.energy.back() / reached - 1) < 1e-12);
  RC_ASSERT(std::is_sorted(result.energy.rbegin(), result.energy.rend()));
  const test::Topology before = test::topology(scene.mesh, scene.labels);
  const test::Topology after = test::topology(scene.mesh, labels);
  RC_ASSERT(after.manifold);
  RC_ASSERT(after.euler == before.euler);
  RC_ASSERT(std::includes(after.vertices.begin(), after.vertices.end(), before.vertices.begin(),
                          before.vertices.end()));
}

}  // namespace
}  // namespace arris
