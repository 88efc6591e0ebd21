#include "feature/between.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "seed/shapes.h"
#include "support/job.h"
#include "support/random.h"
#include "support/tetra.h"

namespace arris {
namespace {

using namespace test;

// Samples of the two faces of a wedge of material (or of air, turned) round the z axis.
struct Wedge {
  double half;  // angle, radians
  double sign;  // 1: material within, -1: air
  std::vector<Vec3> points;
  std::vector<LocalSurface> surfaces;  // one a point

  Wedge(double degrees, double turned, std::size_t n, Random& random)
      : half(radians(degrees) / 2), sign(turned) {
    for (std::size_t i = 0; i < n; ++i) {
      const double side = i % 2 ? 1 : -1, r = random.between(0.02, 1);
      points.push_back({r * std::cos(half), side * r * std::sin(half), random.between(0, 1)});
      const Vec3 n_out{-std::sin(half), side * std::cos(half), 0};
      surfaces.push_back(tangent_plane(points.back(), sign * n_out));
    }
  }

  Seed truth(Vec3 p) const {
    const bool within = std::abs(std::atan2(p.y, p.x)) < half;
    return within == (sign > 0) ? seed_inside : seed_outside;
  }
};

// Whatever is told is true, and it is told of more than a tenth: those across the wedge that are
// small enough. Of the others between points of one face nothing can be told.
RC_GTEST_PROP(Between, TellsWedgesOfMaterialAndAir, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const double degrees = *rc::gen::element(20.0, 45.0, 90.0, 120.0);
  const Wedge wedge(degrees, *rc::gen::element(-1.0, 1.0), 200, random);
  const TetMesh mesh = delaunay_of(wedge.points);
  const std::vector<double> spacing(wedge.points.size(), 0.2);
  OneStageJob job;
  const std::vector<Seed> told = tetrahedra_between(
      mesh, spacing, [&](Index v) { return std::span(&wedge.surfaces[v], 1); }, 0, job);
  RC_ASSERT(told.size() == mesh.finite);
  std::size_t known = 0;
  for (Tet t = 0; t < mesh.finite; ++t) {
    if (told[t] == seed_free) continue;
    ++known;
    RC_ASSERT(told[t] == wedge.truth(centroid(mesh, t)));
  }
  RC_ASSERT(10 * known > mesh.finite);
}

TEST(Between, TellsNothingWithoutSurfacesOrWhatNoiseHides) {
  Random random(1);
  const Wedge wedge(30, 1, 200, random);
  const TetMesh mesh = delaunay_of(wedge.points);
  const std::vector<double> spacing(wedge.points.size(), 0.2);
  OneStageJob job;
  const auto told = [&](const SurfacesAt& at, double roughness) {
    const std::vector<Seed> all = tetrahedra_between(mesh, spacing, at, roughness, job);
    return std::count_if(all.begin(), all.end(), [](Seed s) { return s != seed_free; });
  };
  const SurfacesAt all = [&](Index v) { return std::span(&wedge.surfaces[v], 1); };
  EXPECT_GT(told(all, 0), 100);
  EXPECT_LT(told(all, 0.05), told(all, 0.01));
  EXPECT_EQ(told(all, 1), 0);
  EXPECT_EQ(told([](Index) { return std::span<const LocalSurface>(); }, 0), 0);
}

}  // namespace
}  // namespace arris
