// Every shape with known facts through reconstruct(), against those facts.
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/clouds.h"
#include "support/measure.h"

namespace arris {
namespace {

using namespace test;

constexpr std::size_t many = 3000, few = 1000;

// Relative deviations from the facts.
struct Deviation {
  double volume = 0, curvature = 0;
};

// The certificate and the topology must be right; how far off the measures are is returned.
Deviation reconstruct_shape(const Shape& shape, std::vector<Vec3> points, const Options& options) {
  const Result<Reconstruction> r = reconstruct(cloud_of(std::move(points)), options);
  EXPECT_TRUE(r) << said(r);
  if (!r) return {1, 1};
  const Certificate& c = r->report.certificate;
  EXPECT_TRUE(c.ok()) << c.first_defect;
  require_manifold(r->mesh);
  EXPECT_EQ(c.components, shape.facts.components);
  EXPECT_EQ(c.euler, shape.facts.euler);
  EXPECT_EQ(euler(r->mesh), shape.facts.euler);
  EXPECT_NEAR(volume(r->mesh), c.volume, 1e-9 * c.volume);
  return {volume(r->mesh) / shape.facts.volume - 1,
          total_mean_curvature(r->mesh) / shape.facts.total_mean_curvature - 1};
}

// Faces, sampled edges and corners are exactly those of the polyhedron, up to rounding.
void expect_exact(const Shape& shape, std::vector<Vec3> points, const Options& options = {}) {
  const Deviation d = reconstruct_shape(shape, std::move(points), options);
  EXPECT_LT(std::abs(d.volume), 1e-12);
  EXPECT_LT(std::abs(d.curvature), 1e-12);
}

// Parts narrower than the method resolves: one sample of the frames' concave edges and four at the
// tip of the wedge are cut off. Measured: volume 3e-4 and 1e-4, curvature 8e-4 and 8e-3.
bool has_narrow_parts(const Shape& shape) {
  return shape.name == "tangled_frames" || shape.name == "wedge";
}

TEST(Shapes, SampledEdgesComeBackExactly) {
  for (const Shape& shape : all_shapes()) {
    if (shape.facts.curved || has_narrow_parts(shape)) continue;
    SCOPED_TRACE(shape.name);
    expect_exact(shape, sample_feature(shape.mesh, many, 1));
  }
}

// Off the axes no face is flat to the last bit: its samples span slivers.
TEST(Shapes, SampledEdgesOfTurnedShapesComeBackExactly) {
  for (const char* name : {"cube", "perforated_cube", "nested_shells", "l_bracket", "octahedron"}) {
    SCOPED_TRACE(name);
    Shape shape = make_shape(name);
    shape.mesh = moved(shape.mesh, 5);
    expect_exact(shape, sample_feature(shape.mesh, many, 1));
  }
}

// The paper's figure 6: where samples are free to leave the surface, least area cuts edges off,
// more than 1 % of the volume, and curvature nearly none.
TEST(Shapes, LeastAreaCutsEdgesOffAndCurvatureDoesNot) {
  const Shape shape = make_shape("cube");
  const std::vector<Vec3> points = sample_feature(shape.mesh, many, 1);
  Options area;
  area.curvature = Curvature::area;
  area.sharpen = false;
  Options curvature;
  curvature.sharpen = false;
  area.keep_samples = curvature.keep_samples = false;
  const double lost = -reconstruct_shape(shape, points, area).volume;
  EXPECT_GT(lost, 0.01);
  EXPECT_LT(-reconstruct_shape(shape, points, curvature).volume, 0.1 * lost);
}

// In some draws the samples beside an edge keep one segment of it out of the Delaunay mesh, and a
// sample or two are cut off. Measured over these: volume 1.4e-4, curvature 9e-3 at most.
TEST(Shapes, UnluckyDrawsCostLittle) {
  for (const char* name : {"nested_shells", "l_bracket"})
    for (std::uint64_t seed : {2u, 4u, 5u}) {
      SCOPED_TRACE(name);
      const Shape shape = make_shape(name);
      const Deviation d = reconstruct_shape(shape, sample_feature(shape.mesh, many, seed), {});
      EXPECT_LT(std::abs(d.volume), 5e-4);
      EXPECT_LT(std::abs(d.curvature), 0.02);
    }
}

TEST(Shapes, NarrowPartsCostLittle) {
  for (const char* name : {"tangled_frames", "wedge"}) {
    SCOPED_TRACE(name);
    const Shape shape = make_shape(name);
    const Deviation d = reconstruct_shape(shape, sample_feature(shape.mesh, many, 1), {});
    EXPECT_LT(std::abs(d.volume), 1e-3);
    EXPECT_LT(std::abs(d.curvature), 0.02);
  }
}

// Chords cut off volume; a Delaunay surface has edges across the lines of curvature, which raise
// the sum of absolute angles. Measured: volume -0.13 to -0.65 %, curvature +14 to +23 %.
TEST(Shapes, CurvedShapesAreNearTheirFacts) {
  for (const Shape& shape : all_shapes()) {
    if (!shape.facts.curved) continue;
    SCOPED_TRACE(shape.name);
    const Deviation d = reconstruct_shape(shape, sample_feature(shape.mesh, many, 1), {});
    EXPECT_LT(d.volume, 0);
    EXPECT_GT(d.volume, -0.01);
    EXPECT_GT(d.curvature, 0);
    EXPECT_LT(d.curvature, 0.3);
  }
}

// Nothing on the edges, and none added: they come out chamfered. Measured: volume -3.0 %
// (tangled_frames) to -0.15 %, curvature +14 to +29 %.
TEST(Shapes, UnsampledEdgesAreCutButTheTopologyIsRight) {
  Options blunt;
  blunt.sharpen = false;
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    const Deviation d = reconstruct_shape(shape, sample_blue(shape.mesh, many, 1), blunt);
    EXPECT_LT(d.volume, 0);
    EXPECT_GT(d.volume, -0.04);
    EXPECT_LT(std::abs(d.curvature), 0.35);
  }
}

// Measured: volume 3e-5, curvature 1.2 % on the cube; exact on the bracket.
TEST(Shapes, PolyhedraByThePaper) {
  for (const char* name : {"cube", "l_bracket", "octahedron"}) {
    SCOPED_TRACE(name);
    const Shape shape = make_shape(name);
    const Deviation d = reconstruct_shape(shape, sample_feature(shape.mesh, few, 1), paper());
    EXPECT_LT(std::abs(d.volume), 1e-3);
    EXPECT_LT(std::abs(d.curvature), 0.03);
  }
}

// Measured: volume -1.9 %, curvature +36 %.
TEST(Shapes, TorusByThePaper) {
  const Shape shape = torus();
  const Deviation d = reconstruct_shape(shape, sample_blue(shape.mesh, few, 1), paper());
  EXPECT_LT(std::abs(d.volume), 0.03);
  EXPECT_LT(std::abs(d.curvature), 0.5);
}

}  // namespace
}  // namespace arris
