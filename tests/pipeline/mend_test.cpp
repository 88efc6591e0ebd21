// Small handles are mended: pinholes through a ball of tetrahedra.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "base/vec.h"
#include "cut/manifold.h"
#include "handles_stage.h"
#include "pipeline/clouds.h"
#include "support/measure.h"
#include "support/random.h"
#include "support/tetra.h"
#include "tetra/locate.h"
#include "truth/models.h"

namespace arris {
namespace {

using namespace test;

// Random points in a cube of side 1; inside is what has its centroid in a ball.
struct Ball {
  Stage stage;
  Labels labels;

  Ball(std::size_t points, Random& random) {
    std::vector<Vec3> x;
    for (std::size_t i = 0; i < points; ++i)
      x.push_back({random.unit(), random.unit(), random.unit()});
    Measured m(std::move(x));
    stage.mesh = std::move(m.mesh);
    stage.stars = std::move(m.stars);
    stage.model.spacing = std::move(m.spacing);
    labels.assign(stage.mesh.size(), 0);
    for (Tet t = 0; t < stage.mesh.finite; ++t) {
      Vec3 c;
      for (Index v : stage.mesh.vertices[t]) c = c + 0.25 * stage.mesh.points[v];
      labels[t] = distance(c, {0.5, 0.5, 0.5}) < 0.35;
    }
    settle();
  }

  // A pinhole along z, about as wide as tetrahedra are.
  void pierce(double x, double y) {
    constexpr double radius = 0.045;
    constexpr int turns = 8, steps = 200;
    Tet at = 0;
    for (int k = 0; k < turns; ++k)
      for (int i = 0; i <= steps; ++i) {
        const double angle = 2 * std::numbers::pi * k / turns;
        const Vec3 p{x + radius * std::cos(angle), y + radius * std::sin(angle),
                     static_cast<double>(i) / steps};
        const Tet t = locate(stage.mesh, p, at);
        if (t >= stage.mesh.finite) continue;
        at = t;
        labels[t] = 0;
      }
    settle();
  }

  void settle() {
    OneStageJob job;
    Report report;
    remanifold(stage, labels, report, job);
  }

  void mend() {
    OneStageJob job;
    Report report;
    mend_handles(stage, labels, report, job);
  }

  std::int64_t handles() const {
    const Topology t = topology_of(stage.mesh, labels);
    return static_cast<std::int64_t>(t.components) - t.euler / 2;
  }
};

TEST(MendHandles, PinholesThroughABallAreClosed) {
  int pierced = 0, closed = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    Ball ball(1500, random);
    if (ball.handles() > 0) continue;
    const double x = 0.5 + 0.2 * random.unit(), y = 0.5 + 0.2 * random.unit();
    ball.pierce(x, y);
    if (ball.handles() == 0) continue;
    ++pierced;
    ball.mend();
    closed += ball.handles() == 0;
  }
  EXPECT_GE(pierced, 10);
  // Measured: 18 of 21. Round or across the others the shortest loop is longer.
  EXPECT_GE(5 * closed, 4 * pierced);
}

RC_GTEST_PROP(MendHandles, TheSurfaceStaysAManifoldWithNoMoreHandles, (std::uint64_t seed)) {
  Random random(seed);
  Ball ball(*rc::gen::inRange<std::size_t>(20, 800), random);
  const int pinholes = *rc::gen::inRange(0, 6);
  for (int k = 0; k < pinholes; ++k) {
    const double x = random.unit(), y = random.unit();
    ball.pierce(x, y);
  }
  const std::int64_t before = ball.handles();
  const Labels given = ball.labels;
  ball.mend();
  RC_ASSERT(ball.handles() <= before);
  RC_ASSERT((ball.handles() == before) == (ball.labels == given));
  const Stars stars(ball.stage.mesh);
  for (Index v = 0; v < ball.stage.mesh.points.size(); ++v)
    RC_ASSERT(is_regular_vertex(ball.stage.mesh, ball.labels, stars[v], v));
}

// A square ring of bars one spacing wide: four samples round each bar.
TEST(MendHandles, AThinRingStays) {
  constexpr int length = 12;
  std::vector<Vec3> points;
  for (int x = 0; x <= length; ++x)
    for (int y = 0; y <= length; ++y)
      for (int z = 0; z <= 1; ++z)
        if (x <= 1 || y <= 1 || x >= length - 1 || y >= length - 1)
          points.push_back(
              {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  const Result<Reconstruction> r = reconstruct(cloud_of(std::move(points)));
  ASSERT_TRUE(r) << said(r);
  EXPECT_EQ(r->report.certificate.euler, 0);
  EXPECT_NEAR(volume(r->mesh), 4 * (length - 1), 1e-6);
}

// Tunnels that are there stay: of walls and holes of a few spacings.
TEST(MendHandles, TrueTunnelsStay) {
  for (const char* name : {"drilled_bracket", "perforated_cube", "tangled_cubes"})
    for (const std::size_t n : {2000u, 4000u}) {
      const Mesh solid = truth::make_model(name, 64);
      const Result<Reconstruction> r = reconstruct(cloud_of(sample_blue(solid, n, 1)));
      ASSERT_TRUE(r) << said(r);
      EXPECT_EQ(r->report.certificate.euler,
                static_cast<std::int64_t>(solid.vertices.size()) -
                    static_cast<std::int64_t>(solid.triangles.size() / 2))
          << name << ' ' << n;
    }
}

}  // namespace
}  // namespace arris
