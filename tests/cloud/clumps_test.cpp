// Clumps of 20 to 300 points go, wherever they lie; small parts that are sampled as the model stay.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vec.h"
#include "cloud/outliers.h"
#include "cloud/quick_look.h"
#include "support/job.h"
#include "support/measure.h"
#include "support/random.h"
#include "support/samplers.h"
#include "support/shapes.h"

namespace arris {
namespace {

using namespace test;

constexpr std::size_t model_size = 2500;

// A unit sphere, evenly spread, and its spacing.
const std::vector<Vec3>& model() {
  static const std::vector<Vec3> points = sample_blue(sphere().mesh, model_size, 1);
  return points;
}
const double h = ideal_spacing(4 * std::numbers::pi, model_size);

struct Clump {
  Vec3 centre;
  double radius = 0;  // of the ball, or 1.6 standard deviations
  std::vector<Vec3> points;
};

// A ball or a normal cloud, with radii from half a spacing to six.
Clump make_clump(Vec3 centre, Random& random) {
  const auto n = static_cast<std::size_t>(20 * std::pow(15, random.unit()));
  Clump clump{centre, 0.5 * h * std::pow(12, random.unit()), {}};
  const bool is_normal = random.unit() < 0.5;
  while (clump.points.size() < n) {
    const Vec3 d = is_normal ? 1 / 1.6 * Vec3{random.normal(), random.normal(), random.normal()}
                             : std::cbrt(random.unit()) * random.direction();
    clump.points.push_back(centre + clump.radius * d);
  }
  return clump;
}

std::vector<Vec3> joined(std::vector<Vec3> a, const std::vector<Vec3>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<std::uint8_t> outliers_of(const std::vector<Vec3>& points) {
  OneStageJob job;
  return find_outliers(points, job);
}

std::ptrdiff_t count_marked(const std::vector<std::uint8_t>& marked, std::size_t from,
                            std::size_t to) {
  return std::count(marked.begin() + static_cast<std::ptrdiff_t>(from),
                    marked.begin() + static_cast<std::ptrdiff_t>(to), std::uint8_t{1});
}

// Twelve spacings from the surface at least, whatever its radius; inside or outside.
Clump make_clump_apart(Random& random) {
  const double distance = random.unit() < 0.5 ? 0.2 * random.unit() : random.between(1.8, 2.5);
  return make_clump(distance * random.direction(), random);
}

RC_GTEST_PROP(Clumps, ApartFromTheSurfaceTakeNoSampleAlong, (std::uint64_t seed)) {
  Random random(seed);
  const std::vector<Vec3> points = joined(model(), make_clump_apart(random).points);
  RC_ASSERT(count_marked(outliers_of(points), 0, model_size) == 0);
}

TEST(Clumps, ApartFromTheSurfaceGo) {
  constexpr int clumps = 100;
  Random random(9);
  int stay = 0;
  for (int k = 0; k < clumps; ++k) {
    const Clump clump = make_clump_apart(random);
    const std::vector<Vec3> points = joined(model(), clump.points);
    const std::ptrdiff_t left =
        std::ssize(clump.points) - count_marked(outliers_of(points), model_size, points.size());
    stay += left > 5 ? 1 : 0;  // five enclose no more than a speck
  }
  EXPECT_LE(stay, 2);  // of twenty points some are spread evenly by chance
}

// Most of a clump goes, and no sample beyond its reach with it.
RC_GTEST_PROP(Clumps, AcrossTheSurfaceTakeNothingAfarAlong, (std::uint64_t seed)) {
  Random random(seed);
  const Clump clump = make_clump(random.direction(), random);
  const std::vector<Vec3> points = joined(model(), clump.points);
  const std::vector<std::uint8_t> outlier = outliers_of(points);
  const double reach = (clump.points.size() < 40 ? 3 : 2.5) * clump.radius + 4 * h;
  for (std::size_t k = 0; k < model_size; ++k)
    RC_ASSERT(!outlier[k] || distance(points[k], clump.centre) < reach);
}

TEST(Clumps, AcrossTheSurfaceMostlyGo) {
  Random random(11);
  std::ptrdiff_t found = 0, all = 0;
  for (int k = 0; k < 60; ++k) {
    const Clump clump = make_clump(random.direction(), random);
    const std::vector<Vec3> points = joined(model(), clump.points);
    found += count_marked(outliers_of(points), model_size, points.size());
    all += std::ssize(clump.points);
  }
  EXPECT_GT(static_cast<double>(found), 0.85 * static_cast<double>(all));
}

// A hundred points within half a spacing make the surface thin in comparison, for a long way round.
TEST(Clumps, DenseOnesMakeNoStraysOfTheSurface) {
  for (const bool even : {true, false})
    for (const char* name : {"sphere", "cube", "cylinder"}) {
      SCOPED_TRACE(name);
      const Mesh mesh = make_shape(name).mesh;
      std::vector<Vec3> points =
          even ? sample_blue(mesh, model_size, 1) : sample_uniform(mesh, model_size, 1);
      const double spacing = ideal_spacing(area(mesh), model_size);
      const Vec3 centre = points[17];
      Random random(3);
      for (int k = 0; k < 100; ++k)
        points.push_back(centre + 0.5 * spacing * std::cbrt(random.unit()) * random.direction());
      const std::vector<std::uint8_t> outlier = outliers_of(points);
      for (std::size_t k = 0; k < model_size; ++k)
        EXPECT_TRUE(!outlier[k] || distance(points[k], centre) < 5 * spacing);
    }
}

// Spheres, cubes and octahedra of 30 to 300 samples, at the spacing of the model or not.
RC_GTEST_PROP(Clumps, AreNoSmallPartsThatAreSampledAsTheModel, (std::uint64_t seed)) {
  Random random(seed);
  const char* const names[] = {"sphere", "cube", "octahedron"};
  const Mesh shape = make_shape(names[random.below(3)]).mesh;
  const auto n = static_cast<std::size_t>(30 * std::pow(10, random.unit()));
  const double spacing = h * random.between(0.5, 1.5);
  const double scale = spacing / ideal_spacing(area(shape), n);
  const Mesh part = moved(shape, seed, scale, {random.unit() < 0.5 ? 3.0 : 0.0, 0, 0});
  const std::vector<Vec3> points = joined(model(), sample_blue(part, n, seed));
  RC_ASSERT(count_marked(outliers_of(points), 0, points.size()) == 0);
}

// What is spread at random is a clump beside an evenly spread model only.
TEST(Clumps, ModelsAtRandomKeepPartsAtRandom) {
  const std::vector<Vec3> random_model = sample_uniform(sphere().mesh, model_size, 1);
  for (const std::size_t n : {30u, 60u, 200u}) {
    SCOPED_TRACE(n);
    const double scale = std::sqrt(static_cast<double>(n) / model_size);
    const Mesh part = moved(sphere().mesh, 2, scale, {3, 0, 0});
    const std::vector<Vec3> points = joined(random_model, sample_uniform(part, n, 1));
    EXPECT_EQ(count_marked(outliers_of(points), 0, points.size()), 0);
  }
}

TEST(Clumps, ThatTouchTheSurfaceAreSeenByAQuickLook) {
  Random random(5);
  for (int k = 0; k < 20; ++k) {
    const Vec3 centre = random.direction();
    std::vector<Vec3> points = model();
    for (int j = 0; j < 100; ++j)  // as dense as the surface, and linked to it
      points.push_back(centre + 2 * h * std::cbrt(random.unit()) * random.direction());
    OneStageJob job;
    EXPECT_FALSE(has_no_outliers(points, job));
  }
}

}  // namespace
}  // namespace arris
