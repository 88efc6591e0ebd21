// What comes back beside the triangles: positions, attributes, tetrahedra, confidence, report.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/clouds.h"
#include "support/measure.h"
#include "tetra/predicates.h"

namespace arris {
namespace {

using namespace test;

std::vector<double> ramp(std::size_t n, double from, double step) {
  std::vector<double> values(n);
  for (std::size_t i = 0; i < n; ++i) values[i] = from + step * static_cast<double>(i);
  return values;
}

PointCloud coloured_cube(std::size_t n) {
  PointCloud cloud = feature_cloud("cube", n);
  cloud.position_type = ScalarType::f32;
  const std::size_t size = cloud.positions.size();
  std::vector<double> red(size);
  for (std::size_t i = 0; i < size; ++i) red[i] = static_cast<double>(i % 256);
  cloud.attributes = {{"red", ScalarType::u8, red},
                      {"nx", ScalarType::f32, ramp(size, -0.5, 0x1p-12)},
                      {"intensity", ScalarType::u16, ramp(size, 100, 3)},
                      {"gps_time", ScalarType::f64, ramp(size, 1e9 + 0.1, 0.001)},
                      {"label", ScalarType::i32, ramp(size, -7, 1)}};
  cloud.warnings = {"left behind: list"};
  return cloud;
}

TEST(Output, MovedSamplesKeepTheirAttributes) {
  PointCloud cloud = blue_cloud("cube", 3000);
  add_noise(cloud.positions, 0.006, 2);
  cloud.attributes.push_back({"ramp", ScalarType::f64, ramp(cloud.positions.size(), 1, 2)});
  const Result<Reconstruction> r = reconstruct(cloud);
  ASSERT_TRUE(r) << said(r);
  EXPECT_GT(r->report.moved_samples, 2900u);
  EXPECT_NEAR(r->report.noise_median, 0.006, 0.0012);
  ASSERT_EQ(r->mesh.attributes.size(), 1u);
  for (std::size_t v = 0; v < r->mesh.vertices.size(); ++v) {
    const Index s = r->mesh.source[v];
    ASSERT_NE(s, no_index);
    EXPECT_EQ(r->mesh.attributes[0].values[v], cloud.attributes[0].values[s]);
  }
  Options still;
  still.noise = 0;
  const Result<Reconstruction> unmoved = reconstruct(cloud, still);
  ASSERT_TRUE(unmoved) << said(unmoved);
  for (std::size_t v = 0; v < unmoved->mesh.vertices.size(); ++v)
    EXPECT_EQ(unmoved->mesh.vertices[v], cloud.positions[unmoved->mesh.source[v]]);
}

TEST(Output, VerticesKeepTheirPointBitForBit) {
  const PointCloud cloud = coloured_cube(1200);
  const Result<Reconstruction> r = reconstruct(cloud);
  ASSERT_TRUE(r) << said(r);
  EXPECT_EQ(r->mesh.position_type, ScalarType::f32);
  ASSERT_EQ(r->mesh.source.size(), r->mesh.vertices.size());
  for (std::size_t v = 0; v < r->mesh.vertices.size(); ++v)
    EXPECT_EQ(r->mesh.vertices[v], cloud.positions[r->mesh.source[v]]);
}

TEST(Output, AttributesArriveAtTheirPoints) {
  const PointCloud cloud = coloured_cube(1200);
  const Result<Reconstruction> r = reconstruct(cloud);
  ASSERT_TRUE(r) << said(r);
  ASSERT_EQ(r->mesh.attributes.size(), cloud.attributes.size());
  for (std::size_t a = 0; a < cloud.attributes.size(); ++a) {
    const Attribute &given = cloud.attributes[a], &got = r->mesh.attributes[a];
    EXPECT_EQ(got.name, given.name);
    EXPECT_EQ(got.type, given.type);
    ASSERT_EQ(got.values.size(), r->mesh.vertices.size());
    for (std::size_t v = 0; v < got.values.size(); ++v)
      EXPECT_EQ(got.values[v], given.values[r->mesh.source[v]]);
  }
}

TEST(Output, AttributesOfTheWrongLengthAreRefused) {
  PointCloud cloud = coloured_cube(300);
  cloud.attributes[2].values.pop_back();
  const Result<Reconstruction> r = reconstruct(cloud);
  EXPECT_EQ(code_of(r), ErrorCode::usage);
  EXPECT_NE(said(r).find("intensity"), std::string::npos) << said(r);
}

TEST(Output, AddedVerticesHaveNoSourceAndNoAttributes) {
  const PointCloud cloud = coloured_cube(300);
  Options options = paper();
  options.lambda = 0;
  const Result<Reconstruction> r = reconstruct(cloud, options);
  ASSERT_TRUE(r) << said(r);
  std::size_t added = 0;
  for (std::size_t v = 0; v < r->mesh.vertices.size(); ++v) {
    if (r->mesh.source[v] != no_index) {
      EXPECT_EQ(r->mesh.vertices[v], cloud.positions[r->mesh.source[v]]);
      continue;
    }
    ++added;
    EXPECT_EQ(r->confidence[v], 0);
    for (const Attribute& a : r->mesh.attributes) EXPECT_EQ(a.values[v], 0);
  }
  EXPECT_EQ(r->report.surface_samples + added, r->mesh.vertices.size());
  EXPECT_GT(r->report.background_points, 0u);
}

TEST(Output, TetrahedraFillTheMesh) {
  Options options;
  options.tetrahedra = true;
  for (const char* name : {"cube", "torus", "nested_shells"}) {
    const PointCloud cloud = feature_cloud(name, 1500);
    const Result<Reconstruction> r = reconstruct(cloud, options);
    ASSERT_TRUE(r) << said(r);
    double sum = 0;
    for (const auto& t : r->volume.tetrahedra) {
      const auto x = [&](std::size_t k) { return r->volume.vertices[t[k]]; };
      EXPECT_EQ(orient3d(x(0), x(1), x(2), x(3)), 1);
      sum += dot(cross(x(1) - x(0), x(2) - x(0)), x(3) - x(0)) / 6;
    }
    EXPECT_NEAR(sum, volume(r->mesh), 1e-10 * sum) << name;
    EXPECT_NEAR(sum, r->report.certificate.volume, 1e-10 * sum) << name;
  }
}

TEST(Output, ConfidenceIsAShare) {
  PointCloud cloud = blue_cloud("torus", 2000);
  add_noise(cloud.positions, 0.01, 1);
  const Result<Reconstruction> r = reconstruct(cloud);
  ASSERT_TRUE(r) << said(r);
  ASSERT_EQ(r->confidence.size(), r->mesh.vertices.size());
  for (float c : r->confidence) EXPECT_TRUE(c >= 0 && c <= 1) << c;
  EXPECT_TRUE(r->report.contradiction > 0 && r->report.contradiction < 0.5);
}

TEST(Output, ReportCounts) {
  PointCloud cloud = coloured_cube(1000);
  cloud.attributes.clear();
  const std::size_t n = cloud.positions.size();
  cloud.positions.push_back(cloud.positions[0]);
  cloud.positions.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  Options options;
  options.non_finite = NonFinite::drop;
  const Result<Reconstruction> r = reconstruct(cloud, options);
  ASSERT_TRUE(r) << said(r);
  const Report& report = r->report;
  EXPECT_EQ(report.input_points, n + 2);
  EXPECT_EQ(report.duplicate_points, 1u);
  EXPECT_EQ(report.non_finite_points, 1u);
  EXPECT_EQ(report.samples, n);
  EXPECT_EQ(report.surface_samples, r->mesh.vertices.size());
  EXPECT_EQ(report.warnings, cloud.warnings);
  EXPECT_EQ(report.options.cycles, 1);
  EXPECT_EQ(report.options.curvature, Curvature::polyhedral);
  EXPECT_NEAR(report.spacing, ideal_spacing(6, n), 0.3 * ideal_spacing(6, n));
  EXPECT_EQ(report.cut_energy.size(), 1u);
  EXPECT_TRUE(std::is_sorted(report.swap_energy.rbegin(), report.swap_energy.rend()));
}

TEST(Output, NonFinitePointsAreRefusedUnlessDropped) {
  PointCloud cloud = feature_cloud("cube", 300);
  cloud.positions[17].y = std::numeric_limits<double>::infinity();
  const Result<Reconstruction> r = reconstruct(cloud);
  EXPECT_EQ(code_of(r), ErrorCode::bad_points);
  EXPECT_NE(said(r).find("point 17"), std::string::npos) << said(r);
}

}  // namespace
}  // namespace arris
