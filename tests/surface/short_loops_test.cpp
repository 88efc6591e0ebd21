// Loops round the handles of surfaces of cubes.
#include "surface/short_loops.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "base/triangle.h"
#include "base/vec.h"
#include "support/voxels.h"

namespace arris {
namespace {

using namespace test;

constexpr int size = 9;
const Voxels voxels(size);

using Loops = std::vector<std::vector<Index>>;

Loops loops_of(const Solid& solid, int most_sides, double longest = 2) {
  const std::vector<Vec3> points = voxels.points();
  const FacetMesh mesh(voxels.surface(solid), points, 1);
  return short_loops(mesh, points, std::vector<double>(points.size(), 1), most_sides, longest);
}

// Facets that a walk reaches without crossing the loop, from the first.
std::size_t reached(const FacetMesh& mesh, const std::vector<Index>& loop) {
  const auto is_side = [&](Index a, Index b) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index v = loop[k], w = loop[(k + 1) % loop.size()];
      if ((a == v && b == w) || (a == w && b == v)) return true;
    }
    return false;
  };
  std::vector<std::uint8_t> seen(mesh.facets.size(), 0);
  std::vector<Index> queue{0};
  seen[0] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle& t = mesh.facets[queue[i]];
      const Index g = mesh.neighbours[queue[i]][k];
      if (seen[g] || is_side(t[(k + 1) % 3], t[(k + 2) % 3])) continue;
      seen[g] = 1;
      queue.push_back(g);
    }
  return queue.size();
}

// A ring of bars, one cube thick: four sides round a bar, many round the tunnel.
bool frame(int x, int y, int z) {
  const bool rim = x == 1 || x == 7 || y == 1 || y == 7;
  return z == 4 && x >= 1 && x <= 7 && y >= 1 && y <= 7 && rim;
}

TEST(ShortLoops, GoRoundTheBarsOfAFrame) {
  const Loops loops = loops_of(frame, 5);
  ASSERT_FALSE(loops.empty());
  for (const std::vector<Index>& loop : loops) EXPECT_EQ(loop.size(), 4u);
  EXPECT_TRUE(loops_of(frame, 3).empty());
  EXPECT_TRUE(loops_of(frame, 5, 0.9).empty());  // all sides are longer
}

// Along the inside of the frame; a diagonal saves a side at a corner.
TEST(ShortLoops, AreCrossedByLongOnes) {
  const std::vector<Vec3> points = voxels.points();
  const FacetMesh mesh(voxels.surface(frame), points, 1);
  const std::vector<Index> loop = loops_of(frame, 5).at(0);
  const int sides = sides_across(mesh, loop, 100);
  EXPECT_GE(sides, 16);
  EXPECT_LE(sides, 20);
  EXPECT_EQ(sides_across(mesh, loop, sides), sides);
  EXPECT_EQ(sides_across(mesh, loop, sides - 1), sides);
  EXPECT_EQ(sides_across(mesh, loop, 5), 6);
}

// Four sides go round a bar as well, but they bound its end.
TEST(ShortLoops, ThereIsNoneWithoutAHandle) {
  EXPECT_TRUE(loops_of([](int, int y, int z) { return y == 4 && z == 4; }, 5).empty());
  EXPECT_TRUE(loops_of([](int, int, int z) { return z == 4; }, 5).empty());
  EXPECT_TRUE(loops_of([](int, int, int) { return false; }, 5).empty());
}

TEST(ShortLoops, LongOnesAreNoneOfThem) {
  const auto thick = [](int x, int y, int z) {
    const bool hole = x >= 3 && x <= 5 && y >= 3 && y <= 5;
    return z >= 2 && z <= 6 && !hole;
  };
  EXPECT_TRUE(loops_of(thick, 11).empty());
  EXPECT_FALSE(loops_of(thick, 12).empty());
}

// Through a plate with pinholes: no loop parts the surface, no two share a point, and each is at a
// pinhole.
RC_GTEST_PROP(ShortLoops, DoNotPartTheSurface, ()) {
  const auto holes = *rc::gen::container<std::vector<bool>>(16, rc::gen::arbitrary<bool>());
  const auto is_hole = [&](int x, int y) {
    return x % 2 == 1 && y % 2 == 1 && holes[static_cast<std::size_t>(x / 2 * 4 + y / 2)];
  };
  const Solid plate = [&](int x, int y, int z) { return z == 4 && !is_hole(x, y); };
  const std::vector<Vec3> points = voxels.points();
  const FacetMesh mesh(voxels.surface(plate), points, 1);
  const Loops loops = short_loops(mesh, points, std::vector<double>(points.size(), 1), 5, 2);
  RC_ASSERT(loops.empty() == (std::count(holes.begin(), holes.end(), true) == 0));
  std::vector<std::uint8_t> used(points.size(), 0);
  for (const std::vector<Index>& loop : loops) {
    RC_ASSERT(loop.size() >= 3u && loop.size() <= 5u);
    for (Index v : loop) RC_ASSERT(!std::exchange(used[v], std::uint8_t{1}));
    RC_ASSERT(reached(mesh, loop) == mesh.facets.size());
    const auto at_hole = [&](Index v) {
      const int x = static_cast<int>(points[v].x), y = static_cast<int>(points[v].y);
      return is_hole(x, y) || is_hole(x - 1, y) || is_hole(x, y - 1) || is_hole(x - 1, y - 1);
    };
    RC_ASSERT(std::any_of(loop.begin(), loop.end(), at_hole));
  }
}

}  // namespace
}  // namespace arris
