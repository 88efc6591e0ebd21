#include "seed/seeds.h"

#include <gtest/gtest.h>

#include "support/known_solids.h"

namespace arris {
namespace {

using namespace test;

Seeds seeds_of(const Measured& m) {
  OneStageJob job;
  return find_seeds(m.mesh, m.stars, m.balls, m.spacing, job);
}

// Farther from the surface than this many spacings, a centroid is clearly inside or outside.
constexpr double clearly = 0.25;

struct Count {
  std::size_t right = 0, wrong = 0, free = 0;
};

Count count_clear(const KnownSolid& solid, const Measured& m, const Seeds& seeds) {
  Count count;
  for (Tet t = 0; t < m.mesh.finite; ++t) {
    const double d = solid.distance(centroid_of(m.mesh, t));
    if (std::abs(d) < clearly * mean_spacing(m.mesh, m.spacing, t)) continue;
    if (seeds.label[t] == seed_free)
      ++count.free;
    else
      ++(seeds.label[t] == (d < 0 ? seed_inside : seed_outside) ? count.right : count.wrong);
  }
  return count;
}

TEST(Seeds, LabelsClearOfTheSurfaceAreRight) {
  for (const KnownSolid& solid : known_solids(2000)) {
    SCOPED_TRACE(solid.name);
    const Measured m(solid.samples);
    const Seeds seeds = seeds_of(m);
    const Count count = count_clear(solid, m, seeds);
    EXPECT_GT(count.right, 500u);
    EXPECT_EQ(count.wrong, 0u);
    EXPECT_LT(count.free, count.right / 50);
    EXPECT_LT(seeds.contradiction, 0.02);
  }
}

TEST(Seeds, FirmSeedsAreRightEvenNearTheSurface) {
  for (const KnownSolid& solid : known_solids(2000)) {
    const Measured m(solid.samples);
    const Seeds seeds = seeds_of(m);
    std::size_t firm = 0;
    for (Tet t = 0; t < m.mesh.finite; ++t) {
      const double d = solid.distance(centroid_of(m.mesh, t));
      // Slivers between samples of the surface are on either side.
      if (!seeds.firm[t] || std::abs(d) < 0.1 * mean_spacing(m.mesh, m.spacing, t)) continue;
      ++firm;
      EXPECT_EQ(seeds.label[t], d < 0 ? seed_inside : seed_outside) << solid.name << " " << d;
    }
    EXPECT_GT(firm, 1000u) << solid.name;
  }
}

TEST(Seeds, ACavityIsOutside) {
  const KnownSolid shells = known_solids(3000)[3];
  const Measured m(shells.samples);
  const Seeds seeds = seeds_of(m);
  double cavity = 0;
  for (Tet t = 0; t < m.mesh.finite; ++t) {
    const Vec3 c = centroid_of(m.mesh, t);
    if (box_distance(c, 1, 4) > -0.2 || box_distance(c, 2, 3) < 0.2) continue;
    EXPECT_EQ(seeds.label[t], seed_outside);
    const auto& v = m.mesh.vertices[t];
    const Vec3 a = m.mesh.points[v[0]];
    cavity += dot(cross(m.mesh.points[v[1]] - a, m.mesh.points[v[2]] - a), m.mesh.points[v[3]] - a);
  }
  EXPECT_GT(cavity / 6, 10);  // of the 26 there are
}

TEST(Seeds, ConfidenceIsAShareAndFallsWithNoise) {
  const double noise = 0.04;  // about half the spacing
  std::vector<Vec3> points = sample_blue(sphere().mesh, 2000, 1), noisy = points;
  add_noise(noisy, noise, 1);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].z > 0) points[i] = noisy[i];
  const Measured m(points);
  const Seeds seeds = seeds_of(m);
  ASSERT_EQ(seeds.confidence.size(), points.size());
  double clean_sum = 0, noisy_sum = 0, clean = 0, rough = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_TRUE(seeds.confidence[i] >= 0 && seeds.confidence[i] <= 1);
    if (points[i].z < -0.15) clean_sum += seeds.confidence[i], ++clean;
    if (points[i].z > 0.15) noisy_sum += seeds.confidence[i], ++rough;
  }
  EXPECT_GT(clean_sum / clean, 0.99);
  EXPECT_LT(noisy_sum / rough, 0.97);
  EXPECT_TRUE(seeds.contradiction > 0 && seeds.contradiction < 0.3) << seeds.contradiction;
}

TEST(Seeds, DoNotDependOnThreads) {
  const Measured m(known_solids(4000)[2].samples);
  OneStageJob one(1), three(3);
  const Seeds a = find_seeds(m.mesh, m.stars, m.balls, m.spacing, one),
              b = find_seeds(m.mesh, m.stars, m.balls, m.spacing, three);
  EXPECT_EQ(a.label, b.label);
  EXPECT_EQ(a.firm, b.firm);
  EXPECT_EQ(a.confidence, b.confidence);
  EXPECT_EQ(a.contradiction, b.contradiction);
}

}  // namespace
}  // namespace arris
