// Outliers through reconstruct(): what is dropped, what stays, what is said about it.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>
#include <string>

#include "base/vec.h"
#include "pipeline/clouds.h"
#include "support/measure.h"
#include "support/random.h"

namespace arris {
namespace {

using namespace test;

std::uint64_t removed(const Report& report) {
  return report.stray_outliers + report.surface_outliers;
}

PointCloud with_outliers(const Shape& shape, std::size_t n, double share) {
  std::vector<Vec3> points = sample_blue(shape.mesh, n, 1);
  add_outliers(points, static_cast<std::size_t>(share * static_cast<double>(n)), 3);
  return cloud_of(std::move(points));
}

void expect_topology(const Reconstruction& r, const Facts& facts) {
  EXPECT_TRUE(r.report.certificate.ok());
  EXPECT_EQ(r.report.certificate.components, facts.components);
  EXPECT_EQ(r.report.certificate.euler, facts.euler);
}

TEST(OutlierPipeline, CleanCloudsLoseNothing) {
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    const Result<Reconstruction> r = reconstruct(cloud_of(sample_blue(shape.mesh, 2000, 1)));
    ASSERT_TRUE(r) << said(r);
    EXPECT_EQ(removed(r->report), 0u);
    EXPECT_EQ(r->report.samples, 2000u);
  }
}

TEST(OutlierPipeline, TheSurfaceIgnoresThem) {
  for (const char* name : {"cube", "two_cubes", "sphere", "thin_plate"})
    for (const double share : {0.05, 0.2}) {
      SCOPED_TRACE(name);
      const Shape shape = make_shape(name);
      const Result<Reconstruction> r = reconstruct(with_outliers(shape, 3000, share));
      ASSERT_TRUE(r) << said(r);
      expect_topology(*r, shape.facts);
      EXPECT_NEAR(r->report.certificate.volume / shape.facts.volume, 1, 0.04);
      // Those within a fraction of a spacing of the surface may stay on it.
      const auto left = std::count_if(r->mesh.source.begin(), r->mesh.source.end(),
                                      [](Index s) { return s != no_index && s >= 3000; });
      EXPECT_LT(static_cast<double>(left), 0.1 * share * 3000);
      EXPECT_EQ(r->report.samples + removed(r->report), r->report.input_points);
    }
}

TEST(OutlierPipeline, AreKeptOnRequestAndByThePaper) {
  const PointCloud cloud = with_outliers(cube(), 600, 0.05);
  Options keep;
  keep.outliers = Outliers::keep;
  for (const Options& options : {keep, paper()}) {
    const Result<Reconstruction> r = reconstruct(cloud, options);
    ASSERT_TRUE(r) << said(r);
    EXPECT_EQ(removed(r->report), 0u);
    EXPECT_EQ(r->report.samples, 630u);
    EXPECT_EQ(r->report.options.outliers, Outliers::keep);
  }
}

TEST(OutlierPipeline, ThePaperDropsThemIfAsked) {
  Options options = paper();
  options.outliers = Outliers::drop;
  const Result<Reconstruction> r = reconstruct(with_outliers(cube(), 1000, 0.05), options);
  ASSERT_TRUE(r) << said(r);
  EXPECT_GT(removed(r->report), 30u);
  expect_topology(*r, cube().facts);
  EXPECT_EQ(r->report.cut_energy.size(), 3u);
}

// Eight clumps: apart, inside, and across the surface.
TEST(OutlierPipeline, TheSurfaceIgnoresClumps) {
  for (const char* name : {"cube", "two_cubes", "sphere", "cylinder"}) {
    SCOPED_TRACE(name);
    const Shape shape = make_shape(name);
    constexpr std::size_t n = 4000;
    std::vector<Vec3> points = sample_blue(shape.mesh, n, 1);
    const double h = ideal_spacing(area(shape.mesh), n);
    Random random(7);
    for (std::size_t k = 0; k < 8; ++k) {
      const Vec3 away = random.direction();
      const Vec3 centre = points[random.below(n)] + (k % 2 == 0 ? 8 * h : 0) * away;
      const double radius = h * random.between(0.5, 4);
      for (std::size_t count = 20 + random.below(120); count > 0; --count)
        points.push_back(centre + radius * std::cbrt(random.unit()) * random.direction());
    }
    const Result<Reconstruction> r = reconstruct(cloud_of(std::move(points)));
    ASSERT_TRUE(r) << said(r);
    expect_topology(*r, shape.facts);
    EXPECT_NEAR(r->report.certificate.volume / shape.facts.volume, 1, 0.02);
    EXPECT_EQ(r->report.samples + removed(r->report), r->report.input_points);
  }
}

TEST(OutlierPipeline, SmallPartsStay) {
  const Shape big = make_shape("cube");
  std::vector<Vec3> points = sample_blue(big.mesh, 4000, 1);
  const double h = ideal_spacing(area(big.mesh), 4000);
  std::int64_t parts = 0;
  for (const char* name : {"sphere", "cube", "octahedron"})
    for (const std::size_t n : {40u, 120u}) {
      const Mesh mesh = make_shape(name).mesh;
      const Mesh part = moved(mesh, n, h / ideal_spacing(area(mesh), n),
                              {1.5 + 0.3 * static_cast<double>(parts++), 0.5, 0.5});
      const std::vector<Vec3> samples = sample_blue(part, n, 2);
      points.insert(points.end(), samples.begin(), samples.end());
    }
  const Result<Reconstruction> r = reconstruct(cloud_of(std::move(points)));
  ASSERT_TRUE(r) << said(r);
  EXPECT_EQ(r->report.stray_outliers, 0u);
  EXPECT_EQ(static_cast<std::int64_t>(r->report.certificate.components), 1 + parts);
  EXPECT_EQ(r->report.certificate.euler, 2 * (1 + parts));
}

// Off the surface in the mesh, and every other vertex an input point with its attributes.
TEST(OutlierPipeline, SourcesStayRight) {
  PointCloud cloud = with_outliers(cube(), 1000, 0.1);
  Attribute id{"id", ScalarType::f64, {}};
  for (std::size_t k = 0; k < cloud.positions.size(); ++k)
    id.values.push_back(static_cast<double>(k));
  cloud.attributes.push_back(id);
  const Result<Reconstruction> r = reconstruct(cloud);
  ASSERT_TRUE(r) << said(r);
  for (std::size_t v = 0; v < r->mesh.vertices.size(); ++v) {
    const Index s = r->mesh.source[v];
    if (s == no_index) continue;  // a feature point
    EXPECT_EQ(r->mesh.vertices[v], cloud.positions[s]);
    EXPECT_EQ(r->mesh.attributes[0].values[v], static_cast<double>(s));
  }
}

TEST(OutlierPipeline, ThreadsAndOrderMakeNoDifference) {
  PointCloud cloud = with_outliers(torus(), 9000, 0.1);
  Context one, many;
  one.threads = 1;
  many.threads = 4;
  const Result<Reconstruction> a = reconstruct(cloud, {}, one), b = reconstruct(cloud, {}, many);
  std::reverse(cloud.positions.begin(), cloud.positions.end());
  const Result<Reconstruction> c = reconstruct(cloud, {}, one);
  ASSERT_TRUE(a && b && c);
  expect_same_mesh(a->mesh, b->mesh);
  expect_same_mesh(a->mesh, c->mesh);
  EXPECT_EQ(a->report.surface_outliers, b->report.surface_outliers);
}

TEST(OutlierPipeline, TheStageIsToldAndCanBeCancelled) {
  std::set<std::string> seen;
  std::atomic<bool> stop{false};
  Context context;
  context.cancel = &stop;
  context.progress = [&](std::string_view stage, double) {
    seen.emplace(stage);
    if (stage == "outliers") stop = true;
  };
  EXPECT_EQ(code_of(reconstruct(blue_cloud("cube", 600), {}, context)), ErrorCode::cancelled);
  EXPECT_TRUE(seen.contains("outliers"));
}

}  // namespace
}  // namespace arris
