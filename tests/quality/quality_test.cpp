// The guard: reconstructions of shapes made by code, held against the truth. The bounds and why
// they are what they are stand in figures.h.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ostream>
#include <string>
#include <vector>

#include "arris/reconstruct.h"
#include "base/vec.h"
#include "compare/compare.h"
#include "quality/figures.h"
#include "support/samplers.h"
#include "support/shapes.h"

namespace arris::test {

void PrintTo(const QualityCase& c, std::ostream* out) {
  *out << c.shape;
}

namespace {

constexpr std::uint64_t seed = 3;
constexpr double noise_part = 0.0025;  // of the diagonal
constexpr unsigned points_per_outlier = 50;

const char* name(Sampling sampling) {
  switch (sampling) {
    case Sampling::feature:
      return "feature";
    case Sampling::blue:
      return "blue";
    case Sampling::refined:
      return "refined";
    case Sampling::uniform:
      return "uniform";
    case Sampling::noise:
      return "noise";
    case Sampling::outliers:
      return "outliers";
  }
  return "unknown";
}

double diagonal_of(const Mesh& mesh) {
  Vec3 low = mesh.vertices[0], high = low;
  for (const Vec3 p : mesh.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return distance(low, high);
}

std::vector<Vec3> sample(const Mesh& mesh, Sampling sampling, std::size_t n) {
  if (sampling == Sampling::feature) return sample_feature(mesh, n, seed);
  if (sampling == Sampling::uniform) return sample_uniform(mesh, n, seed);
  std::vector<Vec3> points = sample_blue(mesh, n, seed);
  if (sampling == Sampling::noise) add_noise(points, noise_part * diagonal_of(mesh), seed);
  if (sampling == Sampling::outliers) add_outliers(points, n / points_per_outlier, seed);
  return points;
}

Figures figures_of(const compare::Comparison& c) {
  const double edges = c.features.length_truth > 0 ? c.features.strict.f1 : no_edges;
  return {1e4 * c.chamfer, edges, c.result_to_truth.normal_error, 1 - c.volume_iou,
          c.same_topology ? Topology::right : Topology::wrong};
}

// As a row of figures.h, cut to the digits that are worth recording.
std::string row(const QualityCase& c, const Figures& f) {
  char text[256];
  std::snprintf(text, sizeof text,
                "    {\"%s\", Sampling::%s, %u, {%.3f, %.3f, %.2f, %.5f, Topology::%s}},", c.shape,
                name(c.sampling), c.samples, f.chamfer, f.edge_f1, f.normal_error, f.volume_deficit,
                f.topology == Topology::right ? "right" : "wrong");
  return text;
}

class Quality : public testing::TestWithParam<QualityCase> {};

TEST_P(Quality, IsAsGoodAsRecorded) {
  const QualityCase& c = GetParam();
  // Turned, so that no face is flat to the last bit and no edge lies on a grid.
  const Mesh truth = moved(make_shape(c.shape).mesh, seed);
  PointCloud cloud;
  cloud.positions = sample(truth, c.sampling, c.samples);
  Options how;
  how.refine = c.sampling == Sampling::refined;
  const auto result = reconstruct(cloud, how);
  ASSERT_TRUE(result) << result.error().message;
  compare::CompareOptions options;
  options.samples = 30000;
  options.ndc = false;
  const auto comparison = compare::compare_meshes(result->mesh, truth, options);
  ASSERT_TRUE(comparison) << comparison.error().message;

  const Figures now = figures_of(*comparison), &was = c.recorded;
  if (std::getenv("ARRIS_PRINT_FIGURES") != nullptr) std::printf("%s\n", row(c, now).c_str());
  SCOPED_TRACE("recorded " + row(c, was) + "\n     now " + row(c, now));
  EXPECT_LE(now.chamfer, (1 + freedom::chamfer_part) * was.chamfer + freedom::chamfer);
  EXPECT_GE(now.edge_f1, was.edge_f1 - freedom::edge_f1);
  EXPECT_LE(now.normal_error, (1 + freedom::normal_part) * was.normal_error + freedom::normal);
  EXPECT_LE(now.volume_deficit, (1 + freedom::volume_part) * was.volume_deficit + freedom::volume);
  EXPECT_GE(now.topology, was.topology);
  EXPECT_TRUE(result->report.certificate.ok()) << result->report.certificate.first_defect;
}

INSTANTIATE_TEST_SUITE_P(Cases, Quality, testing::ValuesIn(quality_cases), [](const auto& test) {
  return std::string(test.param.shape) + "_" + name(test.param.sampling);
});

}  // namespace
}  // namespace arris::test
