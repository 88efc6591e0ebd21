// Booleans against the laws of volume, and random solids made of them.
#include "truth/boolean.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "arris/check.h"
#include "base/vec.h"
#include "truth/csg.h"
#include "truth/measure.h"
#include "truth/shapes.h"

namespace arris::truth {
namespace {

Mesh box(Vec3 low, Vec3 high) {
  return box_complex({{low, high}});
}

bool certified(const Mesh& mesh) {
  const Result<Certificate> certificate = check(mesh);
  return certificate && certificate->ok();
}

TEST(Boolean, OfTwoCubes) {
  const Mesh a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 1, 1}, {3, 3, 3});
  const auto both = combine(a, b, Operation::unite);
  const auto less = combine(a, b, Operation::subtract);
  const auto shared = combine(a, b, Operation::intersect);
  ASSERT_TRUE(both && less && shared);
  EXPECT_DOUBLE_EQ(volume(*both), 15);
  EXPECT_DOUBLE_EQ(volume(*less), 7);
  EXPECT_DOUBLE_EQ(volume(*shared), 1);
  for (const Mesh& mesh : {*both, *less, *shared}) EXPECT_TRUE(certified(mesh));
}

TEST(Boolean, ApartInsideAndNothingLeft) {
  const Mesh a = box({0, 0, 0}, {3, 3, 3}), inside = box({1, 1, 1}, {2, 2, 2});
  const Mesh far = box({5, 5, 5}, {6, 6, 6});
  const auto hollow = combine(a, inside, Operation::subtract);
  ASSERT_TRUE(hollow);
  EXPECT_EQ(components(*hollow), 2u);
  EXPECT_DOUBLE_EQ(volume(*hollow), 26);
  EXPECT_TRUE(certified(*hollow));
  const auto apart = combine(a, far, Operation::unite);
  ASSERT_TRUE(apart);
  EXPECT_EQ(components(*apart), 2u);
  const auto nothing = combine(a, far, Operation::intersect);
  ASSERT_TRUE(nothing);
  EXPECT_TRUE(nothing->triangles.empty());
}

TEST(Boolean, RefusesWhatIsNotManifold) {
  const Mesh a = box({0, 0, 0}, {1, 1, 1});
  EXPECT_FALSE(combine(a, box({1, 1, 0}, {2, 2, 1}), Operation::unite));  // share an edge
}

// Inclusion and exclusion, at random poses.
TEST(Boolean, VolumesAddUp) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh a = moved(icosahedron().mesh, seed);
    const Mesh b = moved(hexagonal_prism().mesh, seed + 100, 1.7, {1.2, 0.3, -0.2});
    const auto both = combine(a, b, Operation::unite);
    const auto less = combine(a, b, Operation::subtract);
    const auto shared = combine(a, b, Operation::intersect);
    ASSERT_TRUE(both && less && shared);
    EXPECT_NEAR(volume(*both) + volume(*shared), volume(a) + volume(b), 1e-9);
    EXPECT_NEAR(volume(*less) + volume(*shared), volume(a), 1e-9);
    EXPECT_GT(volume(*shared), 0.1);
  }
}

// bench/csg_suite.py does the same for hundreds of seeds.
TEST(RandomCsg, SeedsGiveValidModelsWithoutThinParts) {
  std::set<std::string> recipes;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const CsgModel model = random_csg(seed, 32);
    EXPECT_TRUE(certified(model.mesh)) << model.recipe;
    EXPECT_GE(model.thickness.thinnest(), 0.04 * bounds_of(model.mesh.vertices).diagonal());
    EXPECT_LT(dense_samples(model.mesh, model.thickness), 30000u);
    recipes.insert(model.recipe);
  }
  EXPECT_GT(recipes.size(), 4u);
}

TEST(RandomCsg, DependsOnItsSeedAlone) {
  const CsgModel first = random_csg(2, 32), again = random_csg(2, 32), other = random_csg(6, 32);
  EXPECT_EQ(first.mesh.vertices, again.mesh.vertices);
  EXPECT_EQ(first.mesh.triangles, again.mesh.triangles);
  EXPECT_EQ(first.recipe, again.recipe);
  EXPECT_NE(first.mesh.vertices, other.mesh.vertices);
}

}  // namespace
}  // namespace arris::truth
