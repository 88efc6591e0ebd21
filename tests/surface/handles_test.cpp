// The topology of surfaces of cubes, and where it changes.
#include "surface/handles.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/voxels.h"

namespace arris {
namespace {

using namespace test;

constexpr int size = 9;
const Voxels voxels(size);
constexpr std::size_t points = (size + 1) * (size + 1) * (size + 1);

Topology topology(const Solid& solid) {
  return topology_of(voxels.surface(solid), points);
}

ChangedRegions changes(const Solid& before, const Solid& after) {
  return changed_regions(voxels.surface(before), voxels.surface(after), points);
}

bool plate(int, int, int z) {
  return z == 4;
}
bool is_at(int x, int y, int x0, int y0) {
  return x == x0 && y == y0;
}

// A bar along x, with its middle third or without.
Solid bar(bool whole) {
  return [whole](int x, int y, int z) { return is_at(y, z, 4, 4) && (whole || x < 3 || x > 5); };
}

// A frame in the plane of the plate, open at one side or not.
Solid frame(bool closed) {
  return [closed](int x, int y, int z) {
    const bool rim = x == 1 || x == 7 || y == 1 || y == 7;
    const bool in = x >= 1 && x <= 7 && y >= 1 && y <= 7;
    return z == 4 && in && rim && (closed || !is_at(x, y, 7, 4));
  };
}

TEST(Handles, TopologyOfPlatesWithHoles) {
  EXPECT_EQ(topology(plate), (Topology{1, 2}));
  EXPECT_EQ(topology(frame(true)), (Topology{1, 0}));
  EXPECT_EQ(topology(frame(false)), (Topology{1, 2}));
  EXPECT_EQ(topology(bar(false)), (Topology{2, 4}));
  EXPECT_EQ(topology([](int, int, int) { return false; }), (Topology{0, 0}));
  EXPECT_EQ(topology([](int x, int y, int z) { return !(is_at(x, y, 4, 4) && z == 4); }),
            (Topology{2, 4}));  // a cavity
}

TEST(Handles, NothingChangedIsNoRegion) {
  const ChangedRegions r = changes(frame(true), frame(true));
  EXPECT_TRUE(r.handles.empty());
  EXPECT_EQ(std::count(r.of.begin(), r.of.end(), no_index), static_cast<long>(points));
}

TEST(Handles, AClosedFrameHasOneMore) {
  const ChangedRegions closing = changes(frame(false), frame(true));
  EXPECT_EQ(closing.handles, std::vector<std::int64_t>{1});
  EXPECT_EQ(closing.of[voxels.point(7, 4, 4)], 0);
  EXPECT_EQ(closing.of[voxels.point(1, 4, 4)], no_index);
  EXPECT_EQ(changes(frame(true), frame(false)).handles, std::vector<std::int64_t>{-1});
}

TEST(Handles, JoiningAndPartingComponentsIsNone) {
  EXPECT_EQ(changes(bar(false), bar(true)).handles, std::vector<std::int64_t>{0});
  EXPECT_EQ(changes(bar(true), bar(false)).handles, std::vector<std::int64_t>{0});
  const Solid none = [](int, int, int) { return false; };
  EXPECT_EQ(changes(none, bar(true)).handles, std::vector<std::int64_t>{0});
}

// Holes at odd places of a plate are regions of their own, each with the handle it adds or fills,
// though the Euler characteristic of the whole may stay.
RC_GTEST_PROP(Handles, AreFoundWhereTheyAre, ()) {
  const auto holes = [] {
    return *rc::gen::container<std::vector<bool>>(16, rc::gen::arbitrary<bool>());
  };
  const std::vector<bool> before = holes(), after = holes();
  const auto with = [](const std::vector<bool>& holes_at) {
    return [&holes_at](int x, int y, int z) {
      const bool may = x % 2 == 1 && y % 2 == 1;
      return z == 4 && !(may && holes_at[static_cast<std::size_t>(x / 2 * 4 + y / 2)]);
    };
  };
  const ChangedRegions r = changes(with(before), with(after));
  std::size_t changed = 0;
  for (int k = 0; k < 16; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Index region = r.of[voxels.point(k / 4 * 2 + 1, k % 4 * 2 + 1, 4)];
    const int more = static_cast<int>(after[i]) - static_cast<int>(before[i]);
    RC_ASSERT((region == no_index) == (more == 0));
    if (more == 0) continue;
    RC_ASSERT(r.handles[region] == more);
    ++changed;
  }
  RC_ASSERT(r.handles.size() == changed);
  const std::int64_t sum = std::accumulate(r.handles.begin(), r.handles.end(), std::int64_t{0});
  RC_ASSERT(topology(with(after)).euler == topology(with(before)).euler - 2 * sum);
}

}  // namespace
}  // namespace arris
