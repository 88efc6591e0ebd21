// Clouds whose samples are missing in places: what is joined there, and what is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/clouds.h"
#include "support/measure.h"

namespace arris {
namespace {

using namespace test;

// Two unit cubes, 2 apart, with a bar of width 0.3 between their middles.
Mesh dumb_bell() {
  return box_complex(
      {{{0, 0, 0}, {1, 1, 1}}, {{1, 0.35, 0.35}, {3, 0.65, 0.65}}, {{3, 0, 0}, {4, 1, 1}}});
}

template <class Missing>
PointCloud cloud_without(const Mesh& mesh, double spacing, Missing&& missing) {
  std::vector<Vec3> points = sample_blue(mesh, samples_at_spacing(area(mesh), spacing), 1);
  std::erase_if(points, missing);
  return cloud_of(std::move(points));
}

Reconstruction bevelled(const PointCloud& cloud) {
  Options options;
  options.sharpen = false;
  const Result<Reconstruction> r = reconstruct(cloud, options);
  EXPECT_TRUE(r) << said(r);
  return r ? *r : Reconstruction{};
}

void expect_topology(const Reconstruction& r, std::uint64_t components, std::int64_t euler) {
  EXPECT_TRUE(r.report.certificate.ok()) << r.report.certificate.first_defect;
  EXPECT_EQ(r.report.certificate.components, components);
  EXPECT_EQ(r.report.certificate.euler, euler);
}

// Nothing was sampled all round, over one to two widths of the bar. The longer the gap, the thinner
// may be what closes it.
TEST(Gaps, ABarWithoutSamplesInTheMiddleIsOnePart) {
  const Mesh solid = dumb_bell();
  const Reconstruction whole = bevelled(cloud_without(solid, 0.06, [](Vec3) { return false; }));
  for (const double length : {0.3, 0.6}) {
    SCOPED_TRACE(length);
    const PointCloud cloud =
        cloud_without(solid, 0.06, [&](Vec3 p) { return std::abs(p.x - 2) < length / 2; });
    const Reconstruction r = bevelled(cloud);
    expect_topology(r, 1, 2);
    const double missing = length * 0.3 * 0.3;
    EXPECT_NEAR(volume(r.mesh), volume(whole.mesh), (length < 0.5 ? 0.25 : 0.75) * missing);
    EXPECT_GT(std::count(r.filled.begin(), r.filled.end(), 1), 0);
  }
}

TEST(Gaps, TheFeaturesOfAJoinedBarGoOn) {
  const PointCloud cloud =
      cloud_without(dumb_bell(), 0.06, [](Vec3 p) { return std::abs(p.x - 2) < 0.2; });
  const Result<Reconstruction> r = reconstruct(cloud);
  ASSERT_TRUE(r) << said(r);
  expect_topology(*r, 1, 2);
  EXPECT_NEAR(volume(r->mesh), volume(dumb_bell()), 0.002 * volume(dumb_bell()));
}

TEST(Gaps, ARingWithoutSamplesInASectorStaysARing) {
  const PointCloud cloud = cloud_without(
      make_shape("torus").mesh, 0.1, [](Vec3 p) { return std::abs(std::atan2(p.y, p.x)) < 0.3; });
  expect_topology(bevelled(cloud), 1, 0);
}

// Walls that lack samples at the same place face each other, but do not end there.
TEST(Gaps, WallsThatFaceEachOtherAreNotJoined) {
  const Mesh blocks = box_complex({{{0, 0, 0}, {1, 1, 1}}, {{1.4, 0, 0}, {2.4, 1, 1}}});
  const PointCloud cloud = cloud_without(blocks, 0.06, [](Vec3 p) {
    return std::abs(p.x - 1.2) < 0.3 && std::hypot(p.y - 0.5, p.z - 0.5) < 0.25;
  });
  const Reconstruction r = bevelled(cloud);
  expect_topology(r, 2, 4);
  EXPECT_GT(r.report.filled_faces, 0u);
}

// Ends that are sampled are ends.
TEST(Gaps, SampledEndsAreNotJoined) {
  const Mesh bars = box_complex({{{0, 0, 0}, {1, 0.3, 0.3}}, {{1.3, 0, 0}, {2.3, 0.3, 0.3}}});
  const PointCloud cloud = cloud_without(bars, 0.06, [](Vec3) { return false; });
  expect_topology(bevelled(cloud), 2, 4);
}

double nearest_vertex(const Mesh& mesh, Vec3 p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (Vec3 v : mesh.vertices) nearest = std::min(nearest, distance(v, p));
  return nearest;
}

// The planes beside a gap are carried on to where they meet, several spacings from all samples.
TEST(Gaps, ACornerThatNobodySawIsThere) {
  const Mesh cube = box_complex({{{0, 0, 0}, {1, 1, 1}}});
  const PointCloud cloud = cloud_without(cube, 0.06, [](Vec3 p) {
    return distance(p, {1, 1, 1}) < 0.2;
  });
  const Result<Reconstruction> r = reconstruct(cloud);
  ASSERT_TRUE(r) << said(r);
  expect_topology(*r, 1, 2);
  EXPECT_LT(nearest_vertex(r->mesh, {1, 1, 1}), 1e-3);
  EXPECT_NEAR(volume(r->mesh), 1, 1e-4);
}

TEST(Gaps, AConcaveEdgeThatNobodySawIsThere) {
  const Mesh bracket = box_complex({{{0, 0, 0}, {1, 1, 0.5}}, {{0, 0, 0.5}, {0.5, 1, 1}}});
  const PointCloud cloud = cloud_without(bracket, 0.06, [](Vec3 p) {
    return std::hypot(p.x - 0.5, p.z - 0.5) < 0.17 && std::abs(p.y - 0.5) < 0.3;
  });
  const Result<Reconstruction> r = reconstruct(cloud);
  ASSERT_TRUE(r) << said(r);
  expect_topology(*r, 1, 2);
  const double film = 0.6 * 0.17 * 0.17 / 2;  // what a flat film over the edge would close off
  EXPECT_NEAR(volume(r->mesh), 0.75, 0.25 * film);
}

}  // namespace
}  // namespace arris
