// Points over the middles of edges, from a mesh alone.
#include "feature/refine.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "feature/rough_surface.h"

namespace arris {
namespace {

using namespace test;

constexpr std::size_t samples = 1500;

// Delaunay triangles of even samples of the unit sphere.
Mesh ball() {
  Mesh mesh = bevelled_mesh(sphere(), samples, 1);
  for (Vec3& p : mesh.vertices) p = (1 / length(p)) * p;
  return mesh;
}

std::vector<RefinePoint> refined(const Mesh& mesh, double roughness = 0, double shortest = 0,
                                 unsigned threads = 1) {
  OneStageJob job(threads);
  return refine_points(mesh, Measured(mesh.vertices).spacing, roughness, {.shortest = shortest}, job);
}

// Root mean square distances from the unit sphere.
struct Off {
  double foot = 0, position = 0;
};
Off off_sphere(const std::vector<RefinePoint>& points) {
  const auto rms = [&](auto place) {
    double sum = 0;
    for (const RefinePoint& p : points) sum += std::pow(length(place(p)) - 1, 2);
    return std::sqrt(sum / static_cast<double>(points.size()));
  };
  return {rms([](const RefinePoint& p) { return p.foot; }),
          rms([](const RefinePoint& p) { return p.position; })};
}

TEST(RefinePoints, LieOnASphere) {
  const Mesh mesh = ball();
  const std::vector<RefinePoint> points = refined(mesh);
  EXPECT_GT(points.size(), mesh.triangles.size()) << "of three halves as many edges";
  const Off off = off_sphere(points);
  EXPECT_LT(off.position, 0.03 * off.foot);
  for (const RefinePoint& p : points) {
    ASSERT_EQ(p.normals.size(), 1u);
    EXPECT_GT(dot(p.normals[0], p.position), 0.999);
  }
}

RC_GTEST_PROP(RefinePoints, ShortEdgesTakeNone, ()) {
  const double shortest = *rc::gen::inRange(5, 20) * 0.1;
  const Mesh mesh = ball();
  const std::vector<double> spacing = Measured(mesh.vertices).spacing;
  const std::vector<RefinePoint> all = refined(mesh), some = refined(mesh, 0, shortest);
  RC_ASSERT(some.size() < all.size());
  // The feet of short edges are nearer than half of `shortest` to their ends. The others take the
  // same points as without, but for the third sides of facets.
  for (const RefinePoint& p : some) {
    const double edge = 2 * distance(p.foot, mesh.vertices[p.near]);
    RC_ASSERT(edge >= shortest * 2 * p.spacing * (1 - 1e-12));
    RC_ASSERT(std::any_of(all.begin(), all.end(),
                          [&](const RefinePoint& q) { return q.position == p.position; }));
  }
}

// Noise lifts middles too, but never so that the whole becomes rougher: what the fit does not
// explain is not believed.
TEST(RefinePoints, DoNotFollowNoise) {
  const Mesh clean = ball();
  const double h = Measured(clean.vertices).spacing[0];
  for (double noise : {0.01, 0.03, 0.1}) {
    Mesh mesh = clean;
    mesh.vertices = clean.vertices;
    add_noise(mesh.vertices, noise * h, 2);
    const Off off = off_sphere(refined(mesh));
    EXPECT_LT(off.position, off.foot) << noise;
    // Below the roughness no sag counts.
    EXPECT_LT(refined(mesh, noise * h).size(), refined(mesh).size() / 2) << noise;
  }
}

TEST(RefinePoints, PlanesTakeNone) {
  EXPECT_TRUE(refined(bevelled_mesh(cube(), samples, 1)).empty());
}

TEST(RefinePoints, DoNotDependOnThreads) {
  const Mesh mesh = ball();
  const std::vector<RefinePoint> one = refined(mesh), four = refined(mesh, 0, 0, 4);
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].position, four[k].position);
    EXPECT_EQ(one[k].near, four[k].near);
  }
}

}  // namespace
}  // namespace arris
