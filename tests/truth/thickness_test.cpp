// Walls, gaps and details of solids whose measures are known.
#include "truth/thickness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/vec.h"
#include "truth/boolean.h"
#include "truth/clearance.h"
#include "truth/measure.h"
#include "truth/necks.h"
#include "truth/revolution.h"
#include "truth/samplers.h"
#include "truth/shapes.h"

namespace arris::truth {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

TEST(Thickness, OfPlatesAndBalls) {
  const Mesh thin = moved(thin_plate().mesh, 4);
  const Thickness plate = measure_thickness(thin);
  EXPECT_NEAR(plate.wall, 0.05, 1e-9);
  EXPECT_EQ(plate.gap, none);
  EXPECT_EQ(plate.detail, bounds_of(thin.vertices).diagonal());  // one part, one set of edges
  EXPECT_NEAR(plate.thinnest(), 0.05, 1e-9);
  const Thickness ball = measure_thickness(sphere().mesh);
  EXPECT_NEAR(ball.wall, 2, 0.01);
  EXPECT_EQ(ball.gap, none);
}

TEST(Thickness, OfWallsVoidsAndTunnels) {
  const Thickness shells = measure_thickness(moved(nested_shells().mesh, 2));
  EXPECT_NEAR(shells.wall, 1, 1e-9);
  EXPECT_NEAR(shells.gap, 1, 1e-9);
  const Thickness bars = measure_thickness(perforated_cube().mesh);
  EXPECT_NEAR(bars.wall, 1, 1e-9);
  EXPECT_NEAR(bars.gap, 1, 1e-9);
}

// The two sides of an edge come close to each other, but are no wall.
TEST(Thickness, IgnoresEdges) {
  EXPECT_GT(measure_thickness(wedge().mesh).wall, 0.9);
  EXPECT_EQ(measure_thickness(cone().mesh).wall, none);
}

// A pinhole has a share of the surface that no quantile sees; its rim is what tells.
TEST(Thickness, SeesPinholesAndCrumbsAsDetails) {
  const Mesh plate = box_complex({{{-4, -3, -1}, {5, 5, 0.5}}});
  const Mesh drill = revolve({{0, -2}, {0.05, -2}, {0.05, 1}, {0, 1}}, 24);
  const auto drilled = combine(plate, drill, Operation::subtract);
  ASSERT_TRUE(drilled);
  const Thickness t = measure_thickness(*drilled);
  EXPECT_GT(t.gap, 1);
  EXPECT_NEAR(t.detail, 0.1 * std::sqrt(2), 1e-3);
  EXPECT_EQ(t.clearance, none);  // round it is not far
  const Mesh crumb = box_complex({{{0, 0, 0}, {9, 9, 9}}, {{10, 10, 10}, {10.1, 10.1, 10.1}}});
  EXPECT_NEAR(measure_thickness(crumb).detail, 0.1 * std::sqrt(3), 1e-9);
}

// A wedge-shaped gap is nowhere parallel; what counts is its narrow end, on the edges that face
// each other there.
TEST(Clearance, IsTheNarrowEndOfATaperingGap) {
  const Mesh block = box_complex({{{-2, -1, -1}, {2, 1, 1}}});
  const Mesh cutter = convex_hull({{-0.05, -2, -2},
                                   {0.05, -2, -2},
                                   {1, -2, 2},
                                   {-1, -2, 2},
                                   {-0.05, 2, -2},
                                   {0.05, 2, -2},
                                   {1, 2, 2},
                                   {-1, 2, 2}});
  const auto split = combine(block, cutter, Operation::subtract);
  ASSERT_TRUE(split);
  ASSERT_EQ(components(*split), 2u);
  const double narrow = 2 * (0.05 + 0.95 / 4);  // at z = -1
  EXPECT_NEAR(measure_clearance(*split, 1, 0.1), narrow, 1e-9);
  EXPECT_EQ(measure_clearance(*split, 0.5, 0.1), none);  // out of reach
}

TEST(Clearance, IgnoresEdgesAndBarsButNotBlades) {
  for (const Shape& shape : {cube(), wedge(), octahedron(), cone(), sphere(), two_cubes()})
    EXPECT_EQ(measure_clearance(moved(shape.mesh, 7), 0.2, 0.1), none) << shape.name;
  const Mesh bar = revolve({{0, 0}, {0.05, 0}, {0.05, 2}, {0, 2}}, 24);
  EXPECT_EQ(measure_clearance(bar, 0.2, 0.1), none);
  // 11 degrees: beside the sharp edge, the other side is nearer than the way round.
  const Mesh blade =
      convex_hull({{0, 0, 0}, {1, 0, -0.1}, {1, 0, 0.1}, {0, 1, 0}, {1, 1, -0.1}, {1, 1, 0.1}});
  EXPECT_LT(measure_clearance(blade, 0.2, 0.1), 0.05);
  EXPECT_NEAR(measure_clearance(thin_plate().mesh, 0.2, 0.1), 0.05, 1e-9);
}

// The ball has three times the chord for its radius, and the chord is the width of the bar, or that
// of the tunnel.
TEST(Necks, AreBarsTunnelsAndCrumbs) {
  constexpr std::size_t points = 20000;
  const Mesh bar = box_complex(
      {{{0, 0, 0}, {1, 1, 1}}, {{1, 0.47, 0.47}, {2, 0.53, 0.53}}, {{2, 0, 0}, {3, 1, 1}}});
  EXPECT_NEAR(measure_necks(bar, 0.5, points), 3 * 0.06, 1e-9);
  EXPECT_EQ(measure_necks(bar, 0.17, points), none);  // out of reach
  const Mesh drill = revolve({{0, -2}, {0.05, -2}, {0.05, 2}, {0, 2}}, 24);
  const auto tunnel =
      combine(box_complex({{{-1.1, -0.8, -1}, {1, 1, 1}}}), drill, Operation::subtract);
  ASSERT_TRUE(tunnel);
  EXPECT_NEAR(measure_necks(*tunnel, 0.5, points), 3 * 0.1, 0.01);
  const Mesh crumb = box_complex({{{0, 0, 0}, {1, 1, 1}}, {{1.5, 1.5, 1.5}, {1.6, 1.6, 1.6}}});
  EXPECT_NEAR(measure_necks(crumb, 0.5, points), 3 * 0.1, 0.02);
}

TEST(Necks, IgnoreEdgesAndTips) {
  for (const Shape& shape : {cube(), wedge(), octahedron(), cone(), sphere(), two_cubes()})
    EXPECT_EQ(measure_necks(moved(shape.mesh, 7), 0.3, 4000), none) << shape.name;
  EXPECT_EQ(measure_necks(thin_plate().mesh, 0.3, 4000), none);  // a wall
}

TEST(Thickness, SaysHowManySamplesAreDense) {
  const Mesh mesh = thin_plate().mesh;
  const std::size_t n = dense_samples(mesh, measure_thickness(mesh));
  EXPECT_NEAR(ideal_spacing(area(mesh), n), 0.05 / 4, 1e-4);
  const Mesh thick = cube().mesh;
  const std::size_t few = dense_samples(thick, measure_thickness(thick));
  EXPECT_NEAR(ideal_spacing(6, few), std::sqrt(3.0) / 50, 1e-3);
}

}  // namespace
}  // namespace arris::truth
