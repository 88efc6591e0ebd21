#include "feature/insert.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "feature/candidates.h"
#include "feature/point_grid.h"
#include "feature/protect.h"
#include "feature/sensing.h"
#include "support/creases.h"
#include "support/random.h"

namespace arris {
namespace {

using namespace test;

// Against brute force, on both sides of zero, with points on the walls of cells.
RC_GTEST_PROP(PointGrid, VisitsAllWithinACell, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const double cell = *rc::gen::element(0.1, 0.25, 1.0, 3.0);
  const auto coordinate = [&] {
    const double x = random.between(-2, 2);
    return random.below(4) == 0 ? cell * std::round(x / cell) : x;
  };
  PointGrid grid(cell);
  std::vector<Vec3> points(*rc::gen::inRange<std::size_t>(1, 300));
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = {coordinate(), coordinate(), coordinate()};
    grid.add(points[i], static_cast<Index>(i));
  }
  for (int query = 0; query < 20; ++query) {
    const Vec3 x{coordinate(), coordinate(), coordinate()};
    std::set<Index> visited;
    grid.visit(x, cell, [&](Index i) { return visited.insert(i), true; });
    for (std::size_t i = 0; i < points.size(); ++i)
      if (distance(points[i], x) < cell) RC_ASSERT(visited.count(static_cast<Index>(i)) == 1);
    for (const Index i : visited) RC_ASSERT(i < points.size());
  }
}

TEST(PointGrid, LeavesOutWhatIsFar) {
  PointGrid grid(1);
  grid.add({0.5, 0.5, 0.5}, 7);
  std::vector<Index> found;
  const auto visit = [&](Vec3 x) {
    found.clear();
    grid.visit(x, 1, [&](Index i) { return found.push_back(i), true; });
    return found.size();
  };
  EXPECT_EQ(visit({0.9, -0.1, 1.9}), 1u);
  EXPECT_EQ(visit({0.5, 0.5, 2.1}), 0u);
  EXPECT_EQ(visit({-1.5, 0.5, 0.5}), 0u);
}

// The roof of which the x axis is the ridge.
std::vector<LocalSurface> roof() {
  const double half = std::sqrt(0.5);
  return {tangent_plane({}, {0, half, half}), tangent_plane({}, {0, -half, half})};
}

FeaturePoint on_ridge(double x) {
  return {{x, 0, 0}, 1, false, 0, no_index, roof()};
}

std::vector<double> protect(const std::vector<Vec3>& points, const std::vector<double>& marked,
                            const std::vector<double>& given) {
  OneStageJob job;
  std::vector<FeaturePoint> ends, features;
  for (double x : marked) ends.push_back(on_ridge(x));
  for (double x : given) features.push_back(on_ridge(x));
  const FacetMesh none({}, points, 1);
  protect_curves(points, NearestSample(points), none, ends, features, job);
  std::vector<double> all;
  for (const FeaturePoint& f : features) {
    EXPECT_LT(std::hypot(f.position.y, f.position.z), 1e-12);
    EXPECT_EQ(f.surfaces.size(), 2u);
    EXPECT_NEAR(f.spacing, 1, 1e-12);
    all.push_back(f.position.x);
  }
  return all;
}

TEST(Protect, LongGapsAreHalved) {
  const std::vector<Vec3> far{{0, 100, 0}};
  EXPECT_EQ(protect(far, {}, {0, 1.6}), (std::vector<double>{0, 1.6, 0.8}));
  EXPECT_EQ(protect(far, {}, {0, 0.7}).size(), 2u);
  EXPECT_EQ(protect(far, {}, {0, 3}).size(), 2u);  // too far for the same curve
}

// Samples that lie on the ridge end gaps, but are not added.
TEST(Protect, MarkedSamplesEndGaps) {
  EXPECT_EQ(protect({{0, 0, 0}, {1.2, 0, 0}}, {0, 1.2}, {}), (std::vector<double>{0.6}));
  EXPECT_EQ(protect({{1.2, 0, 0}}, {1.2}, {0}), (std::vector<double>{0, 0.6}));
}

TEST(Protect, AGapIsSplitAtTheFootOfWhatEnters) {
  const std::vector<double> all = protect({{0.4, 0.1, -0.1}}, {}, {0, 0.7});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_NEAR(all[2], 0.4, 1e-12);
  EXPECT_EQ(protect({{0.35, 0.3, -0.3}}, {}, {0, 0.7}).size(), 2u);  // outside the ball
  EXPECT_EQ(protect({{0.1, 0.05, 0}}, {}, {0, 0.25}).size(), 2u);    // too short
}

// Whatever the samples beside the ridge: no gap is long, none that may still be split is entered.
RC_GTEST_PROP(Protect, NoGapThatMayBeSplitIsEntered, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  std::vector<Vec3> points(*rc::gen::inRange<std::size_t>(1, 40));
  for (Vec3& p : points) {
    const double out = random.between(0.05, 0.8), side = random.below(2) == 0 ? 1 : -1;
    p = {random.between(0, 6), side * out, -out};
  }
  std::vector<double> given{0};
  while (given.back() < 5) given.push_back(given.back() + random.between(0.4, 2.2));
  std::vector<double> all = protect(points, {}, given);
  RC_ASSERT(std::equal(given.begin(), given.end(), all.begin()));
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const double gap = all[i + 1] - all[i];
    RC_ASSERT(gap > 0.07 && gap <= 0.8);
    if (gap <= 0.3) continue;
    for (const Vec3& p : points)
      RC_ASSERT(distance(p, {(all[i] + all[i + 1]) / 2, 0, 0}) >= 0.499 * gap);
  }
}

// The surface has that gap as a side: nothing is to be won there.
TEST(Protect, GapsThatAreSidesAreLeftAlone) {
  OneStageJob job;
  const Shape shape = octahedron();
  const Vec3 a = shape.mesh.vertices[shape.mesh.triangles[0][0]],
             b = shape.mesh.vertices[shape.mesh.triangles[0][1]];
  const FacetMesh mesh(shape.mesh.triangles, shape.mesh.vertices, 1);
  const Vec3 along = (1 / distance(a, b)) * (b - a), up = 0.5 * (a + b);
  const Vec3 across = (1 / length(up)) * cross(along, up);
  const double half = std::sqrt(0.5);
  const std::vector<LocalSurface> sides{tangent_plane(a, half * ((1 / length(up)) * up + across)),
                                        tangent_plane(a, half * ((1 / length(up)) * up - across))};
  for (const bool known : {true, false}) {
    std::vector<FeaturePoint> features;
    const auto vertex = [&](std::size_t k) {
      return known ? shape.mesh.triangles[0][k] : no_index;
    };
    const std::vector<FeaturePoint> marked{{a, 1, false, 0, vertex(0), sides},
                                           {b, 1, false, 0, vertex(1), sides}};
    protect_curves(shape.mesh.vertices, NearestSample(shape.mesh.vertices), mesh, marked, features,
                   job);
    EXPECT_EQ(features.size(), known ? 0u : 1u);
  }
}

TEST(Protect, WithoutFeaturesNothingIsAdded) {
  EXPECT_TRUE(protect({{0, 0, 0}}, {}, {}).empty());
}

std::vector<FeaturePoint> features_of(const FirstSurface& s) {
  OneStageJob job;
  std::vector<FeaturePoint> features;
  insert_feature_points(s.points, s.points.size(), s.facets, s.spacing, s.sensed, {}, features,
                        job);
  return features;
}

// Features of a polyhedron sampled beside its edges, after one round.
struct Found {
  std::size_t points = 0, off = 0, corners = 0;  // off: farther than 1e-4 h from every edge
  double least_gap = 1e9;                        // between two of them, in units of h
};

Found found_on(const Shape& shape) {
  const std::vector<FeaturePoint> features = features_of(FirstSurface(shape, 3000));
  const Creases creases(shape.mesh);
  Found found;
  found.points = features.size();
  for (const FeaturePoint& f : features) {
    found.off += creases.distance_from(f.position) > 1e-4 * f.spacing;
    for (const FeaturePoint& g : features)
      if (&f != &g)
        found.least_gap = std::min(found.least_gap, distance(f.position, g.position) / f.spacing);
  }
  for (Vec3 c : creases.corners())
    found.corners += std::any_of(features.begin(), features.end(), [&](const FeaturePoint& f) {
      return f.corner && distance(f.position, c) < 1e-4 * f.spacing;
    });
  return found;
}

// Measured: none off and all corners, but for the bracket: two points off by 0.003 h.
TEST(Insert, PointsLieOnTheEdgesOfPolyhedra) {
  const struct {
    const char* name;
    std::size_t corners;  // least
  } cases[] = {{"cube", 8}, {"octahedron", 6}, {"hexagonal_prism", 12}, {"l_bracket", 12}};
  for (const auto& [name, corners] : cases) {
    SCOPED_TRACE(name);
    const Found found = found_on(make_shape(name));
    EXPECT_GT(found.points, 400u);
    EXPECT_LE(found.off, 2u);
    EXPECT_GE(found.corners, corners);
    EXPECT_GT(found.least_gap, 0.07);
  }
}

// Where faces are six spacings wide and have concave edges, some points may be wrong. All corners
// but one of the two cubes are found, those with faces of three quarters of a turn among them.
TEST(Insert, FewPointsLieOffTheEdgesOfNarrowFaces) {
  const struct {
    const char* name;
    std::size_t corners;
  } cases[] = {{"perforated_cube", 40}, {"two_cubes", 19}};
  for (const auto& [name, corners] : cases) {
    SCOPED_TRACE(name);
    const Found found = found_on(make_shape(name));
    EXPECT_GT(found.points, 600u);
    EXPECT_LT(static_cast<double>(found.off), 0.02 * static_cast<double>(found.points));
    EXPECT_GE(found.corners, corners);
  }
}

TEST(Insert, SmoothSurfacesGetNone) {
  for (const char* name : {"sphere", "torus"})
    EXPECT_TRUE(features_of(FirstSurface(make_shape(name), 2000)).empty()) << name;
}

// Samples lie on every edge already.
TEST(Insert, SampledEdgesGetNone) {
  const Shape shape = cube();
  PointCloud cloud;
  cloud.positions = sample_feature(shape.mesh, 2000, 1);
  const Result<Reconstruction> r = reconstruct(cloud, unsharpened());
  ASSERT_TRUE(r);
  EXPECT_TRUE(features_of(FirstSurface(r->mesh, 1)).empty());
}

std::vector<Candidate> corners_of(const FirstSurface& s) {
  OneStageJob job;
  const Crossing crossing{s.points, s.facets, s.spacing, s.sensed};
  return corner_candidates(crossing, crossing_sides(crossing), job);
}

// Noise can give every sample sides of its own, in all directions; every three of those near a
// facet meet somewhere.
TEST(Corners, AreNotSoughtAmongSidesThatAllDisagree) {
  FirstSurface s(make_shape("cube"), 1000);
  ASSERT_FALSE(corners_of(s).empty());
  Random random(3);
  s.sensed = {};
  for (const Vec3 p : s.points) {
    s.sensed.first.push_back(static_cast<Index>(s.sensed.surface.size()));
    for (int side = 0; side < 8; ++side)
      s.sensed.surface.push_back(tangent_plane(p, random.direction()));
  }
  s.sensed.first.push_back(static_cast<Index>(s.sensed.surface.size()));
  EXPECT_TRUE(corners_of(s).empty());
}

}  // namespace
}  // namespace arris
