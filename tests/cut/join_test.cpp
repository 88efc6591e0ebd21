#include "cut/join.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/vec.h"
#include "cut/stumps.h"
#include "support/job.h"
#include "support/samplers.h"
#include "support/shapes.h"
#include "support/tetra.h"
#include "truth/measure.h"

namespace arris {
namespace {

constexpr double half = 0.15;    // of the width of a bar along x
constexpr double middle = 0.25;  // half of where it has no samples

// A bar of length 2 without samples in its middle; the solid is known elsewhere.
struct Bar {
  test::Measured scene;
  Labels labels;

  explicit Bar(double spacing, double half_gap = middle)
      : scene(points(spacing, half_gap)), labels(scene.mesh.size(), 0) {
    for (Tet t = 0; t < scene.mesh.finite; ++t)
      labels[t] = in_bar(centroid(t)) && std::abs(centroid(t).x) > half_gap;
  }

  Vec3 centroid(Tet t) const {
    Vec3 c;
    for (Index v : scene.mesh.vertices[t]) c = c + 0.25 * scene.mesh.points[v];
    return c;
  }
  static bool in_bar(Vec3 p) {
    return std::abs(p.x) < 1 && std::abs(p.y) < half && std::abs(p.z) < half;
  }

 private:
  static std::vector<Vec3> points(double spacing, double half_gap) {
    const Mesh mesh = test::box_complex({{{-1, -half, -half}, {1, half, half}}});
    std::vector<Vec3> points =
        test::sample_blue(mesh, test::samples_at_spacing(truth::area(mesh), spacing), 3);
    std::erase_if(points, [&](Vec3 p) { return std::abs(p.x) < half_gap; });
    return points;
  }
};

TEST(Join, FillsABarBetweenItsStumpsAndChangesNothingElse) {
  const Bar bar(0.05);
  test::OneStageJob job;
  Labels joined = bar.labels;
  EXPECT_EQ(join_stumps(bar.scene.mesh, bar.scene.spacing, joined, job), 1u);
  double filled = 0;
  for (Tet t = 0; t < bar.scene.mesh.size(); ++t) {
    if (joined[t] == bar.labels[t]) continue;
    ASSERT_TRUE(bar.scene.mesh.is_finite(t));
    const Vec3 c = bar.centroid(t);
    EXPECT_LT(std::abs(c.x), middle + 0.15);
    const auto& v = bar.scene.mesh.vertices[t];
    const Vec3 a = bar.scene.mesh.points[v[0]];
    filled += (joined[t] ? 1 : -1) *
              dot(cross(bar.scene.mesh.points[v[1]] - a, bar.scene.mesh.points[v[2]] - a),
                  bar.scene.mesh.points[v[3]] - a) /
              6;
  }
  EXPECT_NEAR(filled, 2 * middle * 4 * half * half, 0.006);
}

TEST(Join, LeavesASurfaceWithoutStumpsAlone) {
  const Bar bar(0.05, 0);
  test::OneStageJob job;
  Labels labels = bar.labels;
  EXPECT_EQ(join_stumps(bar.scene.mesh, bar.scene.spacing, labels, job), 0u);
  EXPECT_EQ(labels, bar.labels);
}

// One cap alone: the rest of the bar is not there.
TEST(Join, LeavesASingleStumpAlone) {
  Bar bar(0.05);
  for (Tet t = 0; t < bar.scene.mesh.finite; ++t)
    if (bar.centroid(t).x > 0) bar.labels[t] = 0;
  const CutSurface surface = cut_surface_of(bar.scene.mesh, bar.scene.spacing, bar.labels);
  EXPECT_TRUE(find_stumps(bar.scene.mesh, surface).axes.empty());
}

}  // namespace
}  // namespace arris
