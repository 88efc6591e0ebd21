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
    const double want = s == no_index ? 0 : cloud.attributes[0].values[s];
    EXPECT_EQ(r->mesh.attributes[0].values[v], want);
  }
  Options still;
  still.noise = 0;
  still.sharpen = false;
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

// The unit sphere without the samples above this height.
PointCloud open_sphere(double height) {
  PointCloud cloud = blue_cloud("sphere", 3000);
  std::erase_if(cloud.positions, [&](Vec3 p) { return p.z > height; });
  return cloud;
}

TEST(Output, FacesSayWhetherSamplesSupportThem) {
  const Result<Reconstruction> r = reconstruct(open_sphere(0.8));
  ASSERT_TRUE(r) << said(r);
  ASSERT_EQ(r->filled.size(), r->mesh.triangles.size());
  ASSERT_EQ(r->support.size(), r->mesh.triangles.size());
  std::uint64_t filled = 0;
  for (std::size_t t = 0; t < r->filled.size(); ++t) {
    EXPECT_GT(r->support[t], 0);
    EXPECT_LE(r->support[t], 1);
    double height = 0;
    for (Index v : r->mesh.triangles[t]) height += r->mesh.vertices[v].z / 3;
    EXPECT_TRUE(!r->filled[t] || height > 0.6);  // the fill is nearly flat, at 0.8
    EXPECT_TRUE(r->support[t] >= 0.5 || r->filled[t] == 1);
    filled += r->filled[t];
  }
  EXPECT_GT(filled, 5u);
  EXPECT_EQ(r->report.filled_faces, filled);
  EXPECT_NEAR(r->report.filled_area, 0.36 / (3.6 + 0.36), 0.03);  // disc, cap left
  EXPECT_TRUE(r->report.certificate.closed());
}

TEST(Output, ATrimmedMeshIsTheRestOfTheWhole) {
  Options trimming;
  trimming.trim = true;
  const PointCloud cloud = open_sphere(0.8);
  const Result<Reconstruction> whole = reconstruct(cloud), open = reconstruct(cloud, trimming);
  ASSERT_TRUE(whole && open) << said(open);
  EXPECT_EQ(open->mesh.triangles.size() + whole->report.filled_faces, whole->mesh.triangles.size());
  EXPECT_EQ(open->report.filled_faces, whole->report.filled_faces);
  EXPECT_TRUE(open->report.trimmed);
  EXPECT_TRUE(open->report.certificate.sound());
  EXPECT_FALSE(open->report.certificate.closed());
  EXPECT_EQ(open->report.certificate.euler, 1);
  EXPECT_EQ(std::count(open->filled.begin(), open->filled.end(), 1), 0);
  EXPECT_EQ(open->support.size(), open->mesh.triangles.size());
  EXPECT_EQ(open->confidence.size(), open->mesh.vertices.size());
  EXPECT_EQ(open->mesh.source.size(), open->mesh.vertices.size());
  EXPECT_EQ(open->features.patch.size(), open->mesh.triangles.size());
  std::size_t next = 0;  // triangles and vertices keep their order
  for (std::size_t t = 0; t < whole->mesh.triangles.size(); ++t) {
    if (whole->filled[t]) continue;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(open->mesh.source[open->mesh.triangles[next][k]],
                whole->mesh.source[whole->mesh.triangles[t][k]]);
    ++next;
  }
}

}  // namespace
}  // namespace arris
