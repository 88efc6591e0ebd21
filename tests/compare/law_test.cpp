// Laws that every comparison keeps.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/vec.h"
#include "compare/compare.h"
#include "support/random.h"
#include "support/shapes.h"

namespace arris::test {
namespace {

using compare::Comparison;

// Not by RapidCheck: a hundred draws would take a minute.
constexpr std::uint32_t draws = 6;

Comparison comparison_of(const Mesh& result, const Mesh& truth, unsigned threads = 1) {
  compare::CompareOptions options;
  options.samples = 5000;
  options.ndc = false;
  Context context;
  context.threads = threads;
  const auto comparison = compare::compare_meshes(result, truth, options, context);
  if (!comparison) throw std::runtime_error(comparison.error().message);
  return *comparison;
}

Mesh shaken(Mesh mesh, double sigma, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& p : mesh.vertices)
    p = p + Vec3{sigma * random.normal(), sigma * random.normal(), sigma * random.normal()};
  return mesh;
}

class EveryShape : public testing::TestWithParam<std::string> {};

TEST_P(EveryShape, IsPerfectAgainstItself) {
  const Mesh mesh = moved(make_shape(GetParam()).mesh, 7);
  const Comparison c = comparison_of(mesh, mesh);
  EXPECT_LT(c.chamfer, 1e-14);
  EXPECT_LT(c.hausdorff, 1e-14);
  EXPECT_EQ(c.loose.f1, 1);
  EXPECT_EQ(c.strict.f1, 1);
  EXPECT_LT(c.result_to_truth.normal_error, 1e-6);
  EXPECT_LT(c.result_to_truth.normal_error_oriented, 1e-6);
  EXPECT_EQ(c.volume_iou, 1);
  EXPECT_TRUE(c.same_topology);
  for (const auto& at : c.sweep) {
    if (at.length_truth > 0) {
      EXPECT_EQ(at.strict.f1, 1) << at.dihedral;
    } else {
      EXPECT_TRUE(std::isnan(at.strict.f1)) << at.dihedral;
    }
    EXPECT_EQ(at.corners_result, at.corners_truth);
  }
  const Facts facts = make_shape(GetParam()).facts;
  EXPECT_EQ(c.truth.certificate.components, facts.components);
  EXPECT_EQ(c.truth.certificate.euler, facts.euler);
  EXPECT_EQ(*c.truth.genus, static_cast<long>(facts.components) - facts.euler / 2);
}

std::vector<std::string> shape_names() {
  std::vector<std::string> names;
  for (const Shape& shape : all_shapes()) names.push_back(shape.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape, testing::ValuesIn(shape_names()),
                         [](const auto& test) { return test.param; });

// Swapping the meshes swaps precision and recall, up to the unit and to other samples.
TEST(ComparisonLaws, IsSymmetric) {
  for (std::uint32_t seed = 1; seed <= draws; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh a = cube().mesh, b = shaken(a, 0.01, seed);
    const Comparison there = comparison_of(b, a), back = comparison_of(a, b);
    const double unit =
        there.diagonal / back.diagonal;  // lengths there, times this, are those back
    EXPECT_LT(std::abs(there.chamfer * unit - back.chamfer), 0.05 * back.chamfer);
    EXPECT_LT(std::abs(there.hausdorff * unit - back.hausdorff), 0.02 * back.hausdorff);
    EXPECT_LT(std::abs(there.volume_iou - back.volume_iou), 1e-3);
    EXPECT_LT(std::abs(there.features.length_result * unit - back.features.length_truth), 1e-12);
    EXPECT_LT(std::abs(there.result_to_truth.normal_error - back.truth_to_result.normal_error), 1);
  }
}

// Lengths are relative: a common motion and scale changes rounding alone, but other samples are
// nearest where two faces are equally near.
TEST(ComparisonLaws, DoesNotSeeMotionAndScale) {
  for (std::uint32_t seed = 1; seed <= draws; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh truth = l_bracket().mesh, result = shaken(truth, 0.02, seed);
    const double scale = std::exp2(8 * static_cast<int>(seed) - 28);
    const Vec3 shift{scale * 3, scale * 1, scale * -2};
    const Comparison here = comparison_of(result, truth);
    const Comparison there =
        comparison_of(moved(result, 0, scale, shift), moved(truth, 0, scale, shift));
    // The box turns with the model, so its diagonal differs.
    const double unit = here.diagonal * scale / there.diagonal;
    EXPECT_LT(std::abs(here.hausdorff * unit - there.hausdorff), 1e-9);
    EXPECT_LT(std::abs(here.chamfer * unit - there.chamfer), 1e-9);
    EXPECT_LT(std::abs(here.volume_iou - there.volume_iou), 5e-3);
    EXPECT_LT(std::abs(here.features.length_result * unit - there.features.length_result), 1e-9);
  }
}

// Moving a mesh further away never brings it nearer.
TEST(ComparisonLaws, FurtherIsWorse) {
  const Mesh truth = torus().mesh;
  double chamfer = 0, iou = 1;
  for (const double shift : {0.01, 0.05, 0.2, 0.5}) {
    Mesh result = truth;
    for (Vec3& p : result.vertices) p = p + Vec3{shift, 0, 0};
    const Comparison c = comparison_of(result, truth);
    EXPECT_GT(c.chamfer, chamfer);
    EXPECT_LT(c.volume_iou, iou);
    chamfer = c.chamfer, iou = c.volume_iou;
  }
}

TEST(ComparisonLaws, SameForAnyNumberOfThreads) {
  const Mesh truth = torus().mesh, result = shaken(truth, 0.01, 3);
  const std::string one = to_json(comparison_of(result, truth, 1));
  EXPECT_EQ(one, to_json(comparison_of(result, truth, 3)));
  EXPECT_EQ(one, to_json(comparison_of(result, truth, 8)));
}

}  // namespace
}  // namespace arris::test
