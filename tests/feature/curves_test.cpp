// The feature network of reconstructed solids whose edges, corners and faces are known.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <ostream>

#include "feature/network_laws.h"
#include "pipeline/clouds.h"

namespace arris::test {
namespace {

struct Row {
  const char* shape;
  std::size_t samples;
  std::size_t convex, concave, corners, patches;
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.shape;
}

const Row rows[] = {
    {"cube", 1200, 12, 0, 8, 6},
    {"two_cubes", 2500, 24, 6, 20, 12},
    {"perforated_cube", 6000, 48, 24, 40, 30},
    {"l_bracket", 2500, 17, 1, 12, 8},
    {"thin_plate", 2500, 12, 0, 8, 6},
    {"octahedron", 1200, 12, 0, 6, 8},
    {"icosahedron", 2500, 30, 0, 12, 20},
    {"dodecahedron", 2500, 30, 0, 20, 12},
    {"hexagonal_prism", 2000, 18, 0, 12, 8},
    {"cylinder", 2500, 2, 0, 0, 3},
    {"sphere", 150, 0, 0, 0, 1},
    {"torus", 400, 0, 0, 0, 1},
};

class KnownCurves : public testing::TestWithParam<Row> {};

TEST_P(KnownCurves, AreFoundOnTheReconstructedMesh) {
  const Row& row = GetParam();
  const Result<Reconstruction> r = reconstruct(feature_cloud(row.shape, row.samples));
  ASSERT_TRUE(r) << said(r);
  const FeatureNetwork& network = r->features;
  expect_sound_curves(r->mesh, network);
  expect_sound_patches(r->mesh, network);
  const FeatureCounts& counts = r->report.features;
  EXPECT_EQ(counts.curves, row.convex + row.concave);
  EXPECT_EQ(counts.convex_curves, row.convex);
  EXPECT_EQ(counts.concave_curves, row.concave);
  EXPECT_EQ(counts.corners, row.corners);
  EXPECT_EQ(counts.ends, 0u);
  EXPECT_EQ(counts.patches, row.patches);
}

INSTANTIATE_TEST_SUITE_P(Shapes, KnownCurves, testing::ValuesIn(rows),
                         [](const auto& test) { return std::string(test.param.shape); });

TEST(Curves, KnowTheirAnglesAndLengths) {
  const Result<Reconstruction> r = reconstruct(feature_cloud("two_cubes", 2500));
  ASSERT_TRUE(r) << said(r);
  double length = 0;
  for (const FeatureCurve& curve : r->features.curves) {
    const double angle = curve.kind == CurveKind::convex ? 90 : 270;
    EXPECT_NEAR(curve.mean_angle, angle, 0.5);
    EXPECT_NEAR(curve.sharpest_angle, angle, 5);
    EXPECT_FALSE(curve.closed);
    length += curve.length;
  }
  EXPECT_NEAR(length, 24.0, 1e-6);  // twelve edges a cube; what is lost inside comes as grooves
  EXPECT_NEAR(r->report.features.length, length, 1e-9);
  for (const FeatureCorner& corner : r->features.corners) EXPECT_GE(corner.degree, 3u);
}

TEST(Curves, OfACylinderAreClosed) {
  const Result<Reconstruction> r = reconstruct(feature_cloud("cylinder", 2500));
  ASSERT_TRUE(r) << said(r);
  for (const FeatureCurve& curve : r->features.curves) {
    EXPECT_TRUE(curve.closed);
    EXPECT_NEAR(curve.length, std::acos(-1.0), 0.01);
    EXPECT_NEAR(curve.mean_angle, 90, 2);
  }
}

TEST(Curves, OfAMeshTakenAsItIs) {
  const Shape cube = make_shape("cube");
  const Result<FeatureNetwork> network = find_features(cube.mesh);
  ASSERT_TRUE(network) << said(network);
  expect_sound_curves(cube.mesh, *network);
  expect_sound_patches(cube.mesh, *network);
  EXPECT_EQ(network->curves.size(), 12u);
  EXPECT_EQ(network->corners.size(), 8u);
  EXPECT_EQ(network->patches, 6u);
}

TEST(Curves, DoNotDependOnThreads) {
  const Mesh mesh = reconstruct(blue_cloud("l_bracket", 4000))->mesh;
  Context one, four;
  one.threads = 1;
  four.threads = 4;
  const auto a = find_features(mesh, one), b = find_features(mesh, four);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->patch, b->patch);
  ASSERT_EQ(a->curves.size(), b->curves.size());
  for (std::size_t k = 0; k < a->curves.size(); ++k) {
    EXPECT_EQ(a->curves[k].vertices, b->curves[k].vertices);
    EXPECT_EQ(a->curves[k].mean_angle, b->curves[k].mean_angle);
  }
}

TEST(Curves, RefuseABrokenMesh) {
  Mesh mesh = make_shape("cube").mesh;
  mesh.triangles[3][1] = 99;
  EXPECT_EQ(code_of(find_features(mesh)), ErrorCode::usage);
  mesh = make_shape("cube").mesh;
  mesh.vertices[2].y = NAN;
  EXPECT_EQ(code_of(find_features(mesh)), ErrorCode::bad_points);
  EXPECT_EQ(find_features(Mesh{})->patches, 0u);
}

// Laws that hold whatever is found: clean, noisy and random samples, few and many.
RC_GTEST_PROP(CurvesProperty, AreChainsThatBoundThePatches, ()) {
  const auto shapes = all_shapes();
  const Shape& shape = shapes[*rc::gen::inRange<std::size_t>(0, shapes.size())];
  const auto n = *rc::gen::inRange<std::size_t>(100, 400);
  const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
  std::vector<Vec3> points = sample_uniform(shape.mesh, n, seed);
  if (*rc::gen::arbitrary<bool>()) add_noise(points, 0.01, seed);
  const Result<Reconstruction> r = reconstruct(cloud_of(points));
  RC_PRE(static_cast<bool>(r));
  expect_sound_curves(r->mesh, r->features);
  expect_sound_patches(r->mesh, r->features);
}

}  // namespace
}  // namespace arris::test
