// Every shape with known facts through reconstruct(), against those facts.
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/clouds.h"
#include "support/measure.h"

namespace arris {
namespace {

using namespace test;

struct Error2 {
  double volume = 0, curvature = 0;  // relative, signed
};

// Certificate and topology must be right; how far the measures are off is returned.
Error2 reconstruct_shape(const Shape& shape, std::vector<Vec3> points, const Options& options) {
  SCOPED_TRACE(shape.name);
  const Result<Reconstruction> r = reconstruct(cloud_of(std::move(points)), options);
  EXPECT_TRUE(r) << said(r);
  if (!r) return {};
  const Certificate& c = r->report.certificate;
  EXPECT_TRUE(c.ok()) << c.first_defect;
  require_manifold(r->mesh);
  EXPECT_EQ(c.components, shape.facts.components);
  EXPECT_EQ(c.euler, shape.facts.euler);
  EXPECT_EQ(euler(r->mesh), shape.facts.euler);
  EXPECT_NEAR(volume(r->mesh), c.volume, 1e-9 * c.volume);
  const Error2 e{volume(r->mesh) / shape.facts.volume - 1,
                 total_mean_curvature(r->mesh) / shape.facts.total_mean_curvature - 1};
  std::printf("%-18s %6zu %5zu  vol %+.2e  curv %+.2e\n", shape.name.c_str(),
              r->mesh.vertices.size(), r->report.manifold_flips, e.volume, e.curvature);
  return e;
}

constexpr std::size_t samples = 3000;

TEST(Shapes, Feature) {
  for (const Shape& shape : all_shapes())
    reconstruct_shape(shape, sample_feature(shape.mesh, samples, 1), {});
}

TEST(Shapes, Blue) {
  for (const Shape& shape : all_shapes())
    reconstruct_shape(shape, sample_blue(shape.mesh, samples, 1), {});
}

TEST(Shapes, Paper) {
  for (const char* name : {"cube", "torus", "l_bracket", "octahedron"}) {
    const Shape shape = make_shape(name);
    reconstruct_shape(shape, sample_feature(shape.mesh, 1000, 1), paper());
  }
}

}  // namespace
}  // namespace arris
