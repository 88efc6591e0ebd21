// Pairs whose figures are known by pencil and paper.
#include <gtest/gtest.h>

#include <cmath>

#include "base/vec.h"
#include "compare/compare.h"
#include "compare/error_map.h"
#include "support/revolution.h"
#include "support/shapes.h"

namespace arris::test {
namespace {

using compare::Comparison;

Comparison comparison_of(const Mesh& result, const Mesh& truth, double dihedral = 30,
                         bool ndc = false) {
  compare::CompareOptions options;
  options.samples = 50000;
  options.dihedral = dihedral;
  options.ndc = ndc;
  const auto comparison = compare::compare_meshes(result, truth, options);
  EXPECT_TRUE(comparison) << comparison.error().message;
  return comparison ? *comparison : Comparison{};
}

Mesh box(Vec3 low, Vec3 high) {
  return box_complex({{low, high}});
}

Mesh scaled(Mesh mesh, double factor) {
  for (Vec3& p : mesh.vertices) p = factor * p;
  return mesh;
}

// Every distance is the offset, up to the flatness of the facets (1.4e-4 of the radius).
TEST(KnownDistances, SphereOfAnotherRadius) {
  const Mesh truth = sphere().mesh;
  const Comparison c = comparison_of(scaled(truth, 1.02), truth);
  const double diagonal = std::sqrt(12.0);
  EXPECT_NEAR(c.diagonal, diagonal, 1e-3);
  const double offset = 0.02 / diagonal;
  for (const double d : {c.chamfer, c.rms, c.hausdorff, c.result_to_truth.p99})
    EXPECT_NEAR(d, offset, 0.03 * offset);
  EXPECT_EQ(c.strict.f1, 0);  // 0.0058 is more than either tolerance
  EXPECT_EQ(c.loose.f1, 0);
  EXPECT_NEAR(c.volume_iou, std::pow(1.02, -3), 5e-4);
  EXPECT_LT(c.result_to_truth.normal_error, 1.5);  // that between neighbouring facets
}

// A cube moved along an axis by t, against the one that stayed: one side is t away; the opposite
// one lies t deep inside, nearer where other faces are near; four slide in their planes.
TEST(KnownDistances, CubeMovedAlongAnAxis) {
  constexpr double t = 0.1;
  const Comparison c = comparison_of(box({t, 0, 0}, {1 + t, 1, 1}), box({0, 0, 0}, {1, 1, 1}));
  const double diagonal = std::sqrt(3.0);
  EXPECT_NEAR(c.hausdorff, t / diagonal, 1e-12);
  const double inside = (1 - std::pow(1 - 2 * t, 3)) / 6;  // mean of min(t, distance to its edge)
  const double slid = t * t / 2;                           // a strip t wide, t / 2 away on average
  EXPECT_NEAR(c.chamfer, (t + inside + 4 * slid) / 6 / diagonal, 1e-4);
  EXPECT_NEAR(c.volume_iou, (1 - t) / (1 + t), 1e-3);
  const double strict = compare::strict_tolerance * diagonal;
  EXPECT_NEAR(c.strict.precision, 4 * (1 - t + 2 * strict) / 6, 2e-3);
  // The four edges along the axis overlap by 1 - t; of the ends, a little more counts.
  EXPECT_NEAR(c.features.strict.recall, 4 * (1 - t + strict) / 12, 2e-3);
  EXPECT_EQ(c.features.corners.recall, 0);
}

TEST(KnownDistances, ThresholdsOfTheSweepAreAngles) {
  const Mesh prism = hexagonal_prism().mesh;  // edges of 60 and of 90 degrees
  const Comparison c = comparison_of(prism, prism);
  const double diagonal = c.diagonal;
  ASSERT_EQ(c.sweep.size(), 4u);
  for (const auto& at : c.sweep) {  // 12 edges of 90 degrees and 6 of 60, each 1 long
    const double expected = at.dihedral <= 60 ? 18 : 12;
    EXPECT_NEAR(at.length_truth * diagonal, expected, 1e-9) << at.dihedral;
    EXPECT_EQ(at.strict.f1, 1) << at.dihedral;
  }
}

// Right angles count at 90 degrees even where coordinates were rounded to single precision.
TEST(KnownDistances, RightAnglesSurviveRounding) {
  Mesh truth = moved(cube().mesh, 11);
  for (Vec3& p : truth.vertices)
    p = {static_cast<double>(static_cast<float>(p.x)), static_cast<double>(static_cast<float>(p.y)),
         static_cast<double>(static_cast<float>(p.z))};
  const Comparison c = comparison_of(truth, truth, 90);
  EXPECT_NEAR(c.features.length_truth * c.diagonal, 12, 1e-5);
  EXPECT_EQ(c.features.corners_truth, 8u);
}

TEST(KnownDistances, CornersAreThoseOfThePolyhedron) {
  EXPECT_EQ(comparison_of(dodecahedron().mesh, dodecahedron().mesh).features.corners_truth, 20u);
  EXPECT_EQ(comparison_of(l_bracket().mesh, l_bracket().mesh).features.corners_truth, 12u);
  EXPECT_EQ(comparison_of(sphere().mesh, sphere().mesh).features.corners_truth, 0u);
  EXPECT_EQ(comparison_of(cone().mesh, cone().mesh).features.corners_truth, 1u);  // the tip
}

// Two boxes that share an eighth of each.
TEST(KnownDistances, VolumeOfOverlappingBoxes) {
  const Comparison c =
      comparison_of(box({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}), box({0, 0, 0}, {1, 1, 1}));
  EXPECT_NEAR(c.volume_iou, 0.125 / 1.875, 2e-3);
  const Comparison apart = comparison_of(box({3, 0, 0}, {4, 1, 1}), box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(apart.volume_iou, 0);
}

// Edge points of the NDC metric lie within its radius of an edge of 90 degrees; those of 60
// degrees are none.
TEST(KnownDistances, NdcSeesRightAnglesOnly) {
  const Comparison cubes = comparison_of(cube().mesh, cube().mesh, 30, true);
  // Its points are so sparse that even a perfect cube gets about 0.61 (0.58 to 0.65 in twelve draws
  // of two programs).
  EXPECT_NEAR(cubes.ndc.edge.f1, 0.615, 0.05);
  // 12 edges with two strips of 0.004 at most, of an area of 6 (in units of the side).
  const double most = 12 * 2 * 0.004 * std::sqrt(3.0) / 6 * 100000;
  EXPECT_LT(static_cast<double>(cubes.ndc.points_truth), most);
  EXPECT_GT(static_cast<double>(cubes.ndc.points_truth), 0.1 * most);
  EXPECT_EQ(comparison_of(dodecahedron().mesh, dodecahedron().mesh, 30, true).ndc.points_truth, 0u);

  Mesh far = cube().mesh;
  for (Vec3& p : far.vertices) p = p + Vec3{0.05, 0.05, 0.05};
  EXPECT_EQ(comparison_of(far, cube().mesh, 30, true).ndc.edge.f1, 0);
}

TEST(KnownDistances, ErrorMapHoldsTheDistanceOfEveryVertex) {
  const Mesh truth = box({0, 0, 0}, {1, 1, 1});
  const Mesh result = box({0, 0, 0}, {1, 1, 1.25});
  const auto distance = compare::DistanceToMesh::make(truth, "truth");
  ASSERT_TRUE(distance);
  EXPECT_EQ(distance->diagonal(), std::sqrt(3.0));
  const auto map = compare::error_map(result, *distance, 0.25);
  ASSERT_TRUE(map);
  ASSERT_EQ(map->attributes.size(), 4u);
  EXPECT_EQ(map->attributes[0].name, "distance");
  for (std::size_t v = 0; v < map->vertices.size(); ++v) {
    const bool moved = map->vertices[v].z > 1;
    EXPECT_NEAR(map->attributes[0].values[v], moved ? 0.25 : 0, 1e-12);
    EXPECT_EQ(map->attributes[1].values[v], moved ? 253 : 68);  // the ends of viridis
  }
}

}  // namespace
}  // namespace arris::test
