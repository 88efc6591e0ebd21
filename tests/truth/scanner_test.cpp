// The scanner sees what can be seen, from where it is seen, and nothing else.
#include "truth/scanner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "base/vec.h"
#include "truth/measure.h"
#include "truth/shapes.h"

namespace arris::truth {
namespace {

TEST(Scanner, HitsLieOnTheSurfaceAndAreAsManyAsAsked) {
  for (const Shape& shape : {two_cubes(), torus(), cone()}) {
    const Mesh mesh = moved(shape.mesh, 3, 2, {5, 0, -1});
    const Samples samples = scan(mesh, 400, 7, 1);
    ASSERT_EQ(samples.size(), 400u) << shape.name;
    for (const Vec3 p : samples.positions) ASSERT_LT(distance_to_mesh(p, mesh), 1e-9);
  }
}

// The void and the cube in it are seen by nobody.
TEST(Scanner, DoesNotSeeThroughWalls) {
  for (const Vec3 p : scan(nested_shells().mesh, 3000, 12, 2).positions) {
    const double nearest_side = std::min({p.x, p.y, p.z, 5 - p.x, 5 - p.y, 5 - p.z});
    ASSERT_LT(std::abs(nearest_side), 1e-9);
  }
}

// From one side half of a ball is seen at most, and each ray meets it from outside, not grazing.
TEST(Scanner, SeesTheNearSideOnly) {
  const Samples samples = scan(sphere().mesh, 2000, 1, 9);
  Vec3 towards_eye;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3 outwards = samples.positions[i];  // the normal of the unit ball, nearly
    EXPECT_LT(dot(samples.directions[i], outwards), -0.15);
    EXPECT_NEAR(length(samples.directions[i]), 1, 1e-12);
    towards_eye = towards_eye - samples.directions[i];
  }
  towards_eye = (1 / length(towards_eye)) * towards_eye;
  for (const Vec3 p : samples.positions) EXPECT_GT(dot(p, towards_eye), 0.1);
}

// Range images are denser where they look straight on, but every side of a cube is seen.
TEST(Scanner, SeesAllSidesOfACube) {
  std::array<int, 6> seen{};
  for (const Vec3 p : scan(cube().mesh, 6000, 12, 4).positions) {
    const std::array<double, 6> d = {p.x, 1 - p.x, p.y, 1 - p.y, p.z, 1 - p.z};
    ++seen[static_cast<std::size_t>(std::min_element(d.begin(), d.end()) - d.begin())];
  }
  for (const int count : seen) EXPECT_GT(count, 600);
}

TEST(Scanner, RefusesWhatItCannotSee) {
  Mesh sliver;  // each of its two sides is a line in every image
  sliver.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1e-300, 0}};
  sliver.triangles = {{0, 1, 2}};
  EXPECT_THROW(scan(sliver, 100, 3, 1), std::invalid_argument);
}

}  // namespace
}  // namespace arris::truth
