#include "truth/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/vec.h"
#include "truth/measure.h"

namespace arris::truth {
namespace {

class Shapes : public testing::TestWithParam<Shape> {};

TEST_P(Shapes, AreWhatPencilAndPaperSay) {
  const Mesh& mesh = GetParam().mesh;
  const Facts& facts = GetParam().facts;
  const double tolerance = facts.curved ? 0.005 : 1e-12;
  EXPECT_NO_THROW(require_manifold(mesh));
  EXPECT_EQ(components(mesh), facts.components);
  EXPECT_EQ(euler(mesh), facts.euler);
  EXPECT_NEAR(volume(mesh), facts.volume, tolerance * facts.volume);
  EXPECT_NEAR(area(mesh), facts.area, tolerance * facts.area);
  EXPECT_NEAR(total_mean_curvature(mesh), facts.total_mean_curvature,
              tolerance * facts.total_mean_curvature);
}

TEST_P(Shapes, KeepTheirFactsWhenMoved) {
  const Facts& facts = GetParam().facts;
  const Mesh mesh = moved(GetParam().mesh, 5, 3, {1, -2, 7});
  const double tolerance = facts.curved ? 0.005 : 1e-12;
  EXPECT_NEAR(volume(mesh), 27 * facts.volume, 27 * tolerance * facts.volume + 1e-10);
  EXPECT_NEAR(area(mesh), 9 * facts.area, 9 * tolerance * facts.area);
  EXPECT_NE(mesh.vertices, GetParam().mesh.vertices);
}

TEST_P(Shapes, AreFoundByName) {
  const Shape shape = make_shape(GetParam().name);
  EXPECT_EQ(shape.mesh.vertices, GetParam().mesh.vertices);
  EXPECT_EQ(shape.mesh.triangles, GetParam().mesh.triangles);
}

INSTANTIATE_TEST_SUITE_P(All, Shapes, testing::ValuesIn(all_shapes()),
                         [](const auto& instance) { return instance.param.name; });

TEST(ShapeNames, UnknownOnesAreRefused) {
  EXPECT_THROW(make_shape("no_such_shape"), std::out_of_range);
}

TEST(BoxComplex, RefusesBoxesThatTouchInAnEdgeOrCorner) {
  EXPECT_THROW(box_complex({{{0, 0, 0}, {1, 1, 1}}, {{1, 1, 0}, {2, 2, 1}}}),
               std::invalid_argument);
  EXPECT_THROW(box_complex({{{0, 0, 0}, {1, 1, 1}}, {{1, 1, 1}, {2, 2, 2}}}),
               std::invalid_argument);
}

TEST(Measure, RefusesBrokenMeshes) {
  Mesh open = cube().mesh;
  open.triangles.pop_back();
  EXPECT_THROW(require_manifold(open), std::invalid_argument);
  Mesh flipped = cube().mesh;
  std::swap(flipped.triangles[0][0], flipped.triangles[0][1]);
  EXPECT_THROW(require_manifold(flipped), std::invalid_argument);
}

TEST(Measure, DistanceToATriangleInAllItsRegions) {
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  EXPECT_DOUBLE_EQ(distance_to_triangle({0.25, 0.25, -2}, a, b, c), 2);
  EXPECT_DOUBLE_EQ(distance_to_triangle({-3, -4, 0}, a, b, c), 5);
  EXPECT_DOUBLE_EQ(distance_to_triangle({4, -4, 0}, a, b, c), 5);
  EXPECT_DOUBLE_EQ(distance_to_triangle({-4, 4, 0}, a, b, c), 5);
  EXPECT_DOUBLE_EQ(distance_to_triangle({0.5, -1, 0}, a, b, c), 1);
  EXPECT_DOUBLE_EQ(distance_to_triangle({-1, 0.5, 0}, a, b, c), 1);
  EXPECT_DOUBLE_EQ(distance_to_triangle({1, 1, 0}, a, b, c), std::sqrt(0.5));
}

}  // namespace

void PrintTo(const Shape& shape, std::ostream* out) {
  *out << shape.name;
}

}  // namespace arris::truth
