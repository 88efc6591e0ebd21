// Points over the middles of edges, from a mesh alone.
#include "feature/refine.h"

#include <gtest/gtest.h>

#include "feature/rough_surface.h"

namespace arris {
namespace {

using namespace test;

constexpr std::size_t samples = 1500;

// Delaunay triangles of even samples of the unit sphere.
const Mesh& ball() {
  static const Mesh mesh = [] {
    Mesh even = bevelled_mesh(sphere(), samples, 1);
    for (Vec3& p : even.vertices) p = (1 / length(p)) * p;
    return even;
  }();
  return mesh;
}

std::vector<RefinePoint> refined(const Mesh& mesh, double roughness = 0, double shortest = 0,
                                 unsigned threads = 1) {
  OneStageJob job(threads);
  return refine_points(mesh, Measured(mesh.vertices).spacing, roughness, {.shortest = shortest},
                       job);
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
  const Mesh& mesh = ball();
  const std::vector<RefinePoint> points = refined(mesh);
  EXPECT_GT(points.size(), mesh.triangles.size()) << "of three halves as many edges";
  const Off off = off_sphere(points);
  EXPECT_LT(off.position, 0.03 * off.foot);
  for (const RefinePoint& p : points) {
    ASSERT_EQ(p.normals.size(), 1u);
    EXPECT_GT(dot(p.normals[0], p.position), 0.999);
  }
}

// The others take the same points as without, in the same order.
TEST(RefinePoints, ShortEdgesTakeNone) {
  const std::vector<RefinePoint> all = refined(ball());
  for (double shortest : {1.1, 1.3, 1.5}) {
    const std::vector<RefinePoint> some = refined(ball(), 0, shortest);
    EXPECT_GT(some.size(), 10u);
    EXPECT_LT(some.size(), all.size());
    auto next = all.begin();
    for (const RefinePoint& p : some) {
      // Twice the spacing of the point is that of the ends.
      const double edge = 2 * distance(p.foot, ball().vertices[p.near]);
      EXPECT_GE(edge, shortest * 2 * p.spacing * (1 - 1e-12));
      next = std::find_if(next, all.end(), [&](const auto& q) { return q.position == p.position; });
      ASSERT_NE(next, all.end());
    }
  }
}

// Noise lifts middles too, but never so that the whole becomes rougher: what the fit does not
// explain is not believed.
TEST(RefinePoints, DoNotFollowNoise) {
  const Mesh& clean = ball();
  const double h = Measured(clean.vertices).spacing[0];
  for (double noise : {0.01, 0.03}) {
    Mesh mesh = clean;
    mesh.vertices = clean.vertices;
    add_noise(mesh.vertices, noise * h, 2);
    const Off off = off_sphere(refined(mesh));
    EXPECT_LT(off.position, off.foot) << noise;
    // Below the roughness no sag counts.
    EXPECT_LT(refined(mesh, noise * h).size(), refined(mesh).size() / 2) << noise;
  }
}

TEST(RefinePoints, DoNotDependOnThreads) {
  const Mesh& mesh = ball();
  const std::vector<RefinePoint> one = refined(mesh), four = refined(mesh, 0, 0, 4);
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].position, four[k].position);
    EXPECT_EQ(one[k].near, four[k].near);
  }
}

}  // namespace
}  // namespace arris
