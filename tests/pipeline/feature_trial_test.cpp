// Which feature points are taken back, on surfaces of cubes: where a handle appears.
#include "feature_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "base/vec.h"
#include "support/voxels.h"

namespace arris {
namespace {

using namespace test;

constexpr int size = 12;

// A round on cubes; what is new is named by its points, which come last.
struct Round {
  std::vector<Vec3> points;
  std::vector<double> spacing;
  std::vector<Triangle> before, after;
  std::vector<FeaturePoint> features;

  // The points that only the new surface has are the features, found from the nearest old ones.
  Round(const Solid& old_solid, const Solid& new_solid) {
    const Voxels voxels(size);
    const std::vector<Vec3> grid = voxels.points();
    before = voxels.surface(old_solid);
    after = voxels.surface(new_solid);
    const auto used_by = [&](const std::vector<Triangle>& triangles) {
      std::vector<bool> used(grid.size(), false);
      for (const Triangle& t : triangles)
        for (Index v : t) used[v] = true;
      return used;
    };
    const std::vector<bool> was = used_by(before), is = used_by(after);
    std::vector<Index> order(grid.size()), number(grid.size());
    std::iota(order.begin(), order.end(), Index{0});
    const auto is_old = [&](Index v) { return was[v] || !is[v]; };
    const auto first = std::stable_partition(order.begin(), order.end(), is_old);
    for (Index v : order) {
      number[v] = static_cast<Index>(points.size());
      points.push_back(grid[v]);
    }
    for (auto* triangles : {&before, &after})
      for (Triangle& t : *triangles)
        for (Index& v : t) v = number[v];
    spacing.assign(points.size(), 1);
    for (auto v = first; v != order.end(); ++v) {
      FeaturePoint p;
      p.position = grid[*v];
      const auto is_nearer = [&](Index a, Index b) {
        return was[a] != was[b] ? was[a]
                                : distance(grid[a], p.position) < distance(grid[b], p.position);
      };
      p.near = number[*std::min_element(order.begin(), first, is_nearer)];
      features.push_back(p);
    }
  }

  bool refuse(RefusedFeatures& refused) const {
    return refuse_features({points, spacing, before, after, features}, refused);
  }
};

// Two posts on a base; a bar joins them at the top, with its middle or without.
bool posts(int x, int y, int z) {
  return y == 5 && z <= 8 && (z == 0 || x == 0 || x == 6);
}
bool arch(int x, int y, int z) {
  return posts(x, y, z) || (y == 5 && z == 8);
}
bool open_arch(int x, int y, int z) {
  return arch(x, y, z) && !(z == 8 && x >= 2 && x <= 4);
}
// The same, and a ridge all along the bar.
bool ridged_arch(int x, int y, int z) {
  return arch(x, y, z) || (y == 5 && z == 9);
}
// The base alone with a step on it.
bool base(int x, int y, int z) {
  return y == 5 && z == 0 && x <= 6;
}
bool stepped(int x, int y, int z) {
  return base(x, y, z) || (y == 5 && z == 1 && x <= 3);
}

TEST(FeatureTrial, AHandleIsTakenBack) {
  const Round round(open_arch, arch);
  ASSERT_EQ(round.features.size(), 8u);
  RefusedFeatures refused;
  EXPECT_TRUE(round.refuse(refused));
  EXPECT_FALSE(refused.at_handles.empty());
  EXPECT_TRUE(round.refuse(refused));  // should it come again: farther
  for (const FeaturePoint& p : round.features)
    EXPECT_TRUE(std::binary_search(refused.at_handles.begin(), refused.at_handles.end(), p.position,
                                   lexicographic_less));
}

TEST(FeatureTrial, WhatIsFarFromTheJoinStaysAtFirst) {
  const Round round(open_arch, ridged_arch);
  const auto refused_of = [&](const RefusedFeatures& refused, bool far) {
    return std::count_if(refused.at_handles.begin(), refused.at_handles.end(),
                         [&](Vec3 p) { return (p.x > 8) == far; });
  };
  RefusedFeatures refused;
  EXPECT_TRUE(round.refuse(refused));
  EXPECT_GT(refused_of(refused, false), 0);
  EXPECT_EQ(refused_of(refused, true), 0);
  while (round.refuse(refused)) continue;  // each time twice as far
  EXPECT_GT(refused_of(refused, true), 0);
}

TEST(FeatureTrial, ItEnds) {
  const Round round(open_arch, arch);
  RefusedFeatures refused;
  int times = 0;
  while (round.refuse(refused)) ASSERT_LT(++times, 10);
  EXPECT_GT(times, 1);
}

TEST(FeatureTrial, OtherChangesStand) {
  RefusedFeatures refused;
  EXPECT_FALSE(Round(base, stepped).refuse(refused));    // the topology is the same
  EXPECT_FALSE(Round(arch, open_arch).refuse(refused));  // a handle less
  const auto parted = [](int x, int y, int z) { return base(x, y, z) && (x < 3 || x > 4); };
  EXPECT_FALSE(Round(parted, base).refuse(refused));  // two components are one
  EXPECT_TRUE(refused.at_handles.empty());
  EXPECT_TRUE(refused.across.empty());
}

}  // namespace
}  // namespace arris
