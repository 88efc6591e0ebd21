#include "cloud/outliers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/vec.h"
#include "cloud/nearest.h"
#include "cloud/quick_look.h"
#include "support/job.h"
#include "support/measure.h"
#include "support/random.h"
#include "support/samplers.h"
#include "support/shapes.h"

namespace arris {
namespace {

using namespace test;

std::size_t removed(const std::vector<Vec3>& points) {
  OneStageJob job;
  const std::vector<std::uint8_t> outlier = find_outliers(points, job);
  return static_cast<std::size_t>(std::count(outlier.begin(), outlier.end(), 1));
}

// How many of the first `samples` points, and of the rest, are found to be outliers.
struct Found {
  std::size_t samples = 0, others = 0;
};
Found found(const std::vector<Vec3>& points, std::size_t samples) {
  OneStageJob job;
  const std::vector<std::uint8_t> outlier = find_outliers(points, job);
  const auto middle = outlier.begin() + static_cast<std::ptrdiff_t>(samples);
  return {static_cast<std::size_t>(std::count(outlier.begin(), middle, 1)),
          static_cast<std::size_t>(std::count(middle, outlier.end(), 1))};
}

// A normal cloud of points.
void add_clump(std::vector<Vec3>& points, Vec3 centre, double sigma, std::size_t n) {
  Random random(7);
  for (std::size_t k = 0; k < n; ++k)
    points.push_back(centre + sigma * Vec3{random.normal(), random.normal(), random.normal()});
}

std::vector<Vec3> joined(std::vector<Vec3> a, const std::vector<Vec3>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(Outliers, EveryCleanCloudKeepsAllItsSamples) {
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    EXPECT_EQ(removed(sample_blue(shape.mesh, 1000, 1)), 0u);
    EXPECT_EQ(removed(sample_feature(shape.mesh, 1000, 1)), 0u);
    EXPECT_EQ(removed(sample_uniform(shape.mesh, 1000, 1)), 0u);
  }
}

TEST(Outliers, AQuickLookClearsCleanCloudsOnly) {
  OneStageJob job;
  for (const Shape& shape : all_shapes()) {
    // Parts that nothing links take a longer look.
    if (shape.name == "tangled_frames" || shape.name == "nested_shells") continue;
    SCOPED_TRACE(shape.name);
    std::vector<Vec3> points = sample_blue(shape.mesh, 1000, 1);
    EXPECT_TRUE(has_no_outliers(points, job));
    std::vector<Vec3> with_clump = points;
    add_clump(with_clump, {9, 9, 9}, 0.01, 50);
    EXPECT_FALSE(has_no_outliers(with_clump, job));
    points.push_back({9, 9, 9});
    EXPECT_FALSE(has_no_outliers(points, job));
  }
}

// The samples of a cube thinned away from one corner, ten to one in density.
TEST(Outliers, GradedSamplesStay) {
  Random random(3);
  std::vector<Vec3> graded;
  for (Vec3 p : sample_blue(cube().mesh, 8000, 1))
    if (random.unit() < std::pow(0.1, p.x)) graded.push_back(p);
  EXPECT_GT(graded.size(), 2000u);
  EXPECT_EQ(removed(graded), 0u);
}

TEST(Outliers, SmallPartsAndCoarseOnesStay) {
  const std::vector<Vec3> model = sample_blue(sphere().mesh, 4000, 1);
  for (std::size_t n : {8u, 20u, 30u, 60u, 300u}) {
    SCOPED_TRACE(n);
    // At the spacing of the model: area in proportion to n.
    const double radius = std::sqrt(static_cast<double>(n) / 4000);
    const Mesh pebble = moved(sphere().mesh, 2, radius, {2, 0, 0});
    EXPECT_EQ(removed(joined(model, sample_blue(pebble, n, 1))), 0u);
  }
  const Mesh beside = moved(cube().mesh, 3, 1, {2, 0, 0});
  EXPECT_EQ(removed(joined(model, sample_blue(beside, 300, 1))), 0u);  // twice the spacing
}

TEST(Outliers, NoiseLosesFewSamples) {
  for (const char* name : {"cube", "sphere", "torus"}) {
    std::vector<Vec3> points = sample_blue(make_shape(name).mesh, 4000, 1);
    add_noise(points, 0.01, 2);  // a third of the spacing
    EXPECT_LE(removed(points), 2u) << name;
  }
}

TEST(Outliers, SmallCloudsAreLeftAlone) {
  std::vector<Vec3> corners;
  for (double x : {0., 1.})
    for (double y : {0., 1.})
      for (double z : {0., 1.}) corners.push_back({x, y, z});
  EXPECT_EQ(removed(corners), 0u);
  corners.push_back({50, 0, 0});
  EXPECT_EQ(removed(corners), 0u);
}

// Uniform ones within two spacings of the surface are left to the first surface.
TEST(Outliers, UniformOnesAwayFromTheSurfaceGo) {
  for (const double share : {0.01, 0.05, 0.1, 0.3})
    for (const char* name : {"cube", "sphere", "thin_plate", "cone"}) {
      SCOPED_TRACE(name);
      const std::size_t n = 4000;
      const Mesh mesh = make_shape(name).mesh;
      std::vector<Vec3> points = sample_blue(mesh, n, 1);
      const auto count = static_cast<std::size_t>(share * static_cast<double>(n));
      add_outliers(points, count, 5);
      const Found f = found(points, n);
      EXPECT_EQ(f.samples, 0u);
      std::size_t near = 0;  // found or not
      const std::vector<Vec3> clean(points.begin(), points.begin() + n);
      const NearestSample tree(clean);
      const double h = ideal_spacing(area(mesh), n);
      for (std::size_t k = n; k < points.size(); ++k) {
        near += tree(points[k]).distance < 3 * h ? 1 : 0;
      }
      EXPECT_GE(f.others + near, count - count / 50);
    }
}

TEST(Outliers, ClumpsGo) {
  for (const std::size_t n : {60u, 120u, 400u})
    for (const double sigma : {0.05, 0.2}) {
      SCOPED_TRACE(n);
      std::vector<Vec3> points = sample_blue(sphere().mesh, 4000, 1);
      add_clump(points, {2.5, 0, 0}, sigma, n);
      const Found f = found(points, 4000);
      EXPECT_EQ(f.samples, 0u);
      EXPECT_GE(f.others, n - n / 20);
    }
}

TEST(Outliers, DroppedSamplesTakeTheirSourceAlong) {
  arris::Samples samples;
  samples.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  samples.source = {4, 3, 2, 0};
  EXPECT_EQ(drop_samples(samples, {0, 1, 0, 1}), 2u);
  EXPECT_EQ(samples.points, (std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(samples.source, (std::vector<Index>{4, 2}));
}

TEST(Outliers, AreTheSameForEveryNumberOfThreads) {
  std::vector<Vec3> points = sample_uniform(torus().mesh, 20000, 1);
  add_outliers(points, 2000, 2);
  OneStageJob one(1), five(5);
  EXPECT_EQ(find_outliers(points, one), find_outliers(points, five));
}

}  // namespace
}  // namespace arris
