// What must not change the answer: threads, the order of the points, where the object stands.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "arris/io.h"
#include "pipeline/clouds.h"

namespace arris {
namespace {

using namespace test;

Context with_threads(unsigned threads) {
  Context context;
  context.threads = threads;
  return context;
}

Reconstruction run(const PointCloud& cloud, const Options& options = {},
                   const Context& context = {}) {
  Result<Reconstruction> r = reconstruct(cloud, options, context);
  EXPECT_TRUE(r) << said(r);
  return r ? std::move(*r) : Reconstruction{};
}

std::string file_bytes(const Mesh& mesh, const std::string& name) {
  const auto path = std::filesystem::path(testing::TempDir()) / name;
  const Result<void> written = write_mesh(path.string(), mesh);
  EXPECT_TRUE(written) << said(written);
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  std::filesystem::remove(path);
  return bytes;
}

PointCloud shuffled(PointCloud cloud, unsigned seed) {
  std::shuffle(cloud.positions.begin(), cloud.positions.end(), std::mt19937_64(seed));
  return cloud;
}

// Large enough that parallel loops split into several chunks.
PointCloud noisy_torus() {
  PointCloud cloud = blue_cloud("torus", 4000);
  add_noise(cloud.positions, 0.005, 2);
  return cloud;
}

TEST(Invariance, ThreadsDoNotChangeAByte) {
  for (const Options& options : {Options{}, paper()}) {
    PointCloud cloud = options.method == Method::paper ? blue_cloud("torus", 800) : noisy_torus();
    const Reconstruction one = run(cloud, options, with_threads(1)),
                         two = run(cloud, options, with_threads(2));
    EXPECT_EQ(file_bytes(one.mesh, "one.ply"), file_bytes(two.mesh, "two.ply"));
    EXPECT_GT(one.mesh.triangles.size(), 100u);
    EXPECT_EQ(one.mesh.source, two.mesh.source);
    EXPECT_EQ(one.confidence, two.confidence);
    EXPECT_EQ(one.report.cut_energy, two.report.cut_energy);
    EXPECT_EQ(one.report.swap_energy, two.report.swap_energy);
  }
}

TEST(Invariance, OrderOfThePointsDoesNotChangeAByte) {
  for (const Options& options : {Options{}, paper()}) {
    const PointCloud cloud =
        options.method == Method::paper ? blue_cloud("torus", 800) : noisy_torus();
    const Reconstruction first = run(cloud, options);
    const PointCloud other = shuffled(cloud, 3);
    const Reconstruction second = run(other, options);
    EXPECT_EQ(file_bytes(first.mesh, "first.ply"), file_bytes(second.mesh, "second.ply"));
    for (std::size_t v = 0; v < second.mesh.source.size(); ++v) {
      const Index s = first.mesh.source[v], t = second.mesh.source[v];
      ASSERT_EQ(s == no_index, t == no_index);
      EXPECT_TRUE(s == no_index || cloud.positions[s] == other.positions[t]);
    }
  }
}

TEST(Invariance, OrderOfCosphericalPointsDoesNotChangeAByte) {
  std::vector<Vec3> grid;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      for (int z = 0; z < 6; ++z)
        if (std::min({x, y, z}) == 0 || std::max({x, y, z}) == 5)
          grid.push_back({1.0 * x, 1.0 * y, 1.0 * z});
  const Reconstruction first = run(cloud_of(grid)), second = run(shuffled(cloud_of(grid), 4));
  expect_same_mesh(first.mesh, second.mesh);
  EXPECT_NEAR(first.report.certificate.volume, 125, 1e-12);
}

TEST(Invariance, DuplicatesDoNotChangeTheMesh) {
  const PointCloud cloud = feature_cloud("l_bracket", 1000);
  PointCloud doubled = cloud;
  doubled.positions.insert(doubled.positions.end(), cloud.positions.begin(), cloud.positions.end());
  const Reconstruction first = run(cloud), second = run(doubled);
  expect_same_mesh(first.mesh, second.mesh);
  EXPECT_EQ(first.mesh.source, second.mesh.source);  // the first of two equal points
  EXPECT_EQ(second.report.duplicate_points, cloud.positions.size());
  EXPECT_EQ(second.report.samples, cloud.positions.size());
}

TEST(Invariance, PowersOfTwoScaleTheMeshBitForBit) {
  const PointCloud cloud = feature_cloud("two_cubes", 1000);
  for (double scale : {0x1p-900, 0x1p-20, 0x1p300, 0x1p900}) {
    PointCloud scaled = cloud;
    for (Vec3& p : scaled.positions) p = scale * p;
    const Reconstruction first = run(cloud), second = run(scaled);
    EXPECT_EQ(first.mesh.triangles, second.mesh.triangles) << scale;
    EXPECT_EQ(first.mesh.source, second.mesh.source);
    for (std::size_t v = 0; v < second.mesh.vertices.size(); ++v)
      ASSERT_EQ(second.mesh.vertices[v], scale * first.mesh.vertices[v]);
  }
}

// Survey coordinates, whose decimals no float can hold.
TEST(Invariance, LargeCoordinatesKeepTopologyAndBits) {
  for (const char* name : {"cube", "torus", "nested_shells"}) {
    const Shape shape = make_shape(name);
    PointCloud cloud = cloud_of(sample_feature(shape.mesh, 2000, 1));
    for (Vec3& p : cloud.positions) p = p + Vec3{5e6 + 0.123456789, 4e5 + 0.987654321, 100.1};
    const Reconstruction r = run(cloud);
    EXPECT_TRUE(r.report.certificate.ok());
    EXPECT_EQ(r.report.certificate.components, shape.facts.components) << name;
    EXPECT_EQ(r.report.certificate.euler, shape.facts.euler) << name;
    for (std::size_t v = 0; v < r.mesh.vertices.size(); ++v)
      if (const Index s = r.mesh.source[v]; s != no_index) {
        ASSERT_EQ(r.mesh.vertices[v], cloud.positions[s]);
      }
  }
}

}  // namespace
}  // namespace arris
