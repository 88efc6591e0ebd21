#include "feature/adopt.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

#include "feature/sensing.h"
#include "support/random.h"
#include "truth/measure.h"

namespace arris {
namespace {

using namespace test;

// A cube of which every sample off the edges knows its face, but for the `open` ones; some may be
// moved off it.
struct KnownCube {
  FirstSurface surface{make_shape("cube"), 2000};
  std::vector<std::uint8_t> open = std::vector<std::uint8_t>(surface.points.size(), 0);
  std::vector<std::vector<LocalSurface>> known =
      std::vector<std::vector<LocalSurface>>(surface.points.size());

  KnownCube() {
    for (Index v = 0; v < surface.points.size(); ++v) known[v] = {face_at(v)};
  }

  LocalSurface face_at(Index v) const {
    const Vec3 p = surface.points[v] - Vec3{0.5, 0.5, 0.5};
    const double most = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const Vec3 n = std::abs(p.x) == most   ? Vec3{p.x, 0, 0}
                   : std::abs(p.y) == most ? Vec3{0, p.y, 0}
                                           : Vec3{0, 0, p.z};
    return tangent_plane(surface.points[v], (1 / length(n)) * n);
  }

  void forget(Index v) {
    open[v] = 1;
    known[v].clear();
  }

  void adopt() { adopt_planes(surface.points, surface.facets, surface.spacing, open, known); }
};

bool is_far_from_edges(Vec3 p) {
  int inner = 0;
  for (double x : {p.x, p.y, p.z}) inner += x > 0.2 && x < 0.8;
  return inner == 2;
}

// Every third point forgets its plane, and a hole of three rings: what was adopted is handed on.
TEST(Adopt, PlanesComeBackFromWhatIsRound) {
  KnownCube cube;
  std::vector<std::uint8_t> hole(cube.open.size(), 0);
  hole[7] = 1;
  spread(cube.surface.facets.facets, 3, hole);
  for (Index v = 0; v < hole.size(); ++v)
    if (hole[v] || v % 3 == 0) cube.forget(v);
  cube.adopt();
  std::size_t judged = 0;
  for (Index v = 0; v < hole.size(); ++v) {
    if (!cube.open[v] || !is_far_from_edges(cube.surface.points[v])) continue;
    ++judged;
    ASSERT_EQ(cube.known[v].size(), 1u) << v;
    EXPECT_GT(dot(cube.known[v][0].n, cube.face_at(v).n), 1 - 1e-9);
  }
  EXPECT_GT(judged, 100u);
}

// A hundredth of the spacing off a plane is where chance puts samples; rounding is not.
TEST(Adopt, OnlyExactSamplesAreTaken) {
  for (const auto& [off, taken] : {std::pair{0.01, false}, std::pair{1e-6, true}}) {
    KnownCube cube;
    for (Index v = 0; v < cube.open.size(); ++v) {
      if (v % 5 != 0 || !is_far_from_edges(cube.surface.points[v])) continue;
      const Vec3 n = cube.face_at(v).n;
      cube.surface.points[v] = cube.surface.points[v] + off * cube.surface.spacing[v] * n;
      cube.forget(v);
    }
    cube.adopt();
    for (Index v = 0; v < cube.open.size(); ++v) {
      if (!cube.open[v]) continue;
      EXPECT_EQ(!cube.known[v].empty(), taken) << v << " off by " << off;
    }
  }
}

// A sample that the surface passes by asks the nearest ones.
TEST(Adopt, SamplesOffTheSurfaceAreTakenToo) {
  KnownCube cube;
  cube.surface.points.push_back({0.4567, 0.5432, 1});
  cube.surface.spacing.push_back(cube.surface.spacing[0]);
  const FacetMesh with_one_more(cube.surface.facets.facets, cube.surface.points, 1);
  cube.open.push_back(1);
  cube.known.emplace_back();
  adopt_planes(cube.surface.points, with_one_more, cube.surface.spacing, cube.open, cube.known);
  ASSERT_EQ(cube.known.back().size(), 1u);
  EXPECT_GT(cube.known.back()[0].n.z, 1 - 1e-9);
}

// A prism whose sharpest edge has ten degrees.
Shape narrow_wedge() {
  const double x = std::tan(5 * std::numbers::pi / 180);
  Shape shape;
  shape.name = "narrow wedge";
  for (double z : {0.0, 0.5})
    for (Vec3 p : {Vec3{0, 0, 0}, Vec3{x, 1, 0}, Vec3{-x, 1, 0}})
      shape.mesh.vertices.push_back({p.x, p.y, z});
  shape.mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                          {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  return shape;
}

// Where it is thinner than the spacing its two sides let no patch grow, and the surface passes
// samples by. Measured: 1.1e-3 of the volume lost at most; without adopted planes two of the six
// have tunnels, and 2.4e-3 is lost.
TEST(Adopt, ANarrowWedgeIsNotPierced) {
  const Shape shape = narrow_wedge();
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    SCOPED_TRACE(seed);
    PointCloud cloud;
    cloud.positions = sample_blue(shape.mesh, 4000, seed);
    const Result<Reconstruction> r = reconstruct(cloud);
    ASSERT_TRUE(r) << r.error().message;
    EXPECT_EQ(r->report.certificate.components, 1u);
    EXPECT_EQ(r->report.certificate.euler, 2);
    EXPECT_GT(volume(r->mesh) / volume(shape.mesh) - 1, -1.3e-3);
  }
}

}  // namespace
}  // namespace arris
