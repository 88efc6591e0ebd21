#include "cut/specks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/vec.h"
#include "support/random.h"
#include "support/tetra.h"

namespace arris {
namespace {

// Random points in a cube of 10 units, 1 a cubic unit: the spacing is about 1 everywhere.
test::Measured make_scene() {
  test::Random random(5);
  std::vector<Vec3> points(1000);
  for (Vec3& p : points) p = {10 * random.unit(), 10 * random.unit(), 10 * random.unit()};
  return test::Measured(std::move(points));
}

// Tetrahedra whose centroid lies in a ball are labelled inside, the others outside.
Labels ball(const TetMesh& mesh, Vec3 centre, double radius) {
  Labels labels(mesh.size(), 0);
  for (Tet t = 0; t < mesh.finite; ++t) {
    Vec3 c;
    for (Index v : mesh.vertices[t]) c = c + 0.25 * mesh.points[v];
    labels[t] = distance(c, centre) < radius;
  }
  return labels;
}

TEST(Specks, AreRemovedAndFilled) {
  const test::Measured scene = make_scene();
  const Labels wanted = ball(scene.mesh, {3, 5, 5}, 2.5);
  Labels labels = wanted;
  const Labels island = ball(scene.mesh, {8.5, 5, 5}, 0.5),
               hollow = ball(scene.mesh, {3, 5, 5}, 0.5);
  ASSERT_TRUE(std::count(island.begin(), island.end(), 1) > 0);
  ASSERT_TRUE(std::count(hollow.begin(), hollow.end(), 1) > 0);
  for (std::size_t t = 0; t < labels.size(); ++t)
    if (island[t] || hollow[t]) labels[t] ^= 1;
  EXPECT_GE(remove_specks(scene.mesh, scene.spacing, labels), 2u);
  EXPECT_EQ(labels, wanted);
}

TEST(Specks, PartsThatTheSamplesResolveStay) {
  const test::Measured scene = make_scene();
  Labels labels = ball(scene.mesh, {2.5, 5, 5}, 2);
  const Labels second = ball(scene.mesh, {7.5, 5, 5}, 2);
  for (std::size_t t = 0; t < labels.size(); ++t)
    if (second[t]) labels[t] = 1;
  const Labels before = labels;
  EXPECT_EQ(remove_specks(scene.mesh, scene.spacing, labels), 0u);
  EXPECT_EQ(labels, before);
}

TEST(Specks, TheLargestPartStaysHoweverSmall) {
  const test::Measured scene = make_scene();
  Labels labels(scene.mesh.size(), 0);
  labels[scene.mesh.finite / 2] = 1;
  EXPECT_EQ(remove_specks(scene.mesh, scene.spacing, labels), 0u);
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 1), 1);
}

TEST(Specks, NothingInsideIsLeftAlone) {
  const test::Measured scene = make_scene();
  Labels labels(scene.mesh.size(), 0);
  EXPECT_EQ(remove_specks(scene.mesh, scene.spacing, labels), 0u);
}

}  // namespace
}  // namespace arris
