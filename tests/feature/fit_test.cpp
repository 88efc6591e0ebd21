#include "feature/fit.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random.h"

namespace arris {
namespace {

using namespace test;

// Members of a patch about the origin, weighted as patches weight them.
struct Cloudlet {
  std::vector<Vec3> points;
  std::vector<double> weight;

  void add(Vec3 p) {
    weight.push_back(std::exp(-squared_length(p) / 4.5));
    points.push_back(p);
  }
  // To lengths in units of h, over the frame of s.
  void fit_robustly(LocalSurface& s, double h = 1) const {
    PatchFit fit;
    fit.start(s, h, 0);
    for (std::size_t k = 0; k < points.size(); ++k) fit.add(points[k], weight[k]);
    fit.fit_robustly(s);
  }
};

// Evenly in the disc of that radius.
Vec3 in_disc(Random& random, double radius) {
  for (;;) {
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    if (x * x + y * y <= 1) return {radius * x, radius * y, 0};
  }
}

double farthest(const Cloudlet& c, const LocalSurface& s, std::size_t count) {
  double far = 0;
  for (std::size_t i = 0; i < count; ++i) far = std::max(far, std::abs(s.distance(c.points[i])));
  return far;
}

bool is_plane(const LocalSurface& s) {
  return s.c[3] == 0 && s.c[4] == 0 && s.c[5] == 0;
}

// A frame that leans from the z axis by up to 15 degrees, as the first facet of a patch does.
LocalSurface leaning_frame(Random& random) {
  const Vec3 n{random.between(-0.19, 0.19), random.between(-0.19, 0.19), 1};
  return tangent_plane({}, (1 / length(n)) * n);
}

RC_GTEST_PROP(Fit, TangentFramesAreOrthonormal, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Vec3 n = random.direction();
  const LocalSurface s = tangent_plane({1, 2, 3}, n);
  RC_ASSERT(std::abs(dot(s.u, s.v)) < 1e-15 && std::abs(dot(s.u, n)) < 1e-15);
  RC_ASSERT(std::abs(length(s.u) - 1) < 1e-15 && length(cross(s.u, s.v) - n) < 1e-15);
  const double d = random.between(-5, 5);
  RC_ASSERT(std::abs(s.distance(Vec3{1, 2, 3} + d * n) - d) < 1e-14);
  RC_ASSERT(length(s.normal(random.direction()) - n) < 1e-15);
}

RC_GTEST_PROP(Fit, APlaneIsFoundExactlyWhateverTheFrame, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  Cloudlet c;
  c.add({});
  while (c.points.size() < 12) c.add(in_disc(random, 3));
  LocalSurface s = leaning_frame(random);
  c.fit_robustly(s);
  RC_ASSERT(is_plane(s));
  RC_ASSERT(farthest(c, s, 12) < 1e-12);
}

// n members of which `off` lie below the plane, by up to `depth`.
Cloudlet plane_with_outliers(Random& random, std::size_t n, std::size_t off, double depth) {
  Cloudlet c;
  c.add({});
  while (c.points.size() < n) {
    Vec3 p = in_disc(random, 3);
    if (c.points.size() >= n - off) p.z = -random.between(0.01, depth);
    c.add(p);
  }
  return c;
}

// As deep as the widest tolerance of a patch lets them, all on one side, as beyond an edge.
RC_GTEST_PROP(Fit, APlaneIsFoundExactlyAmongTwentyPercentOutliers, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Cloudlet c = plane_with_outliers(random, 28, 5, 0.08);
  LocalSurface s = leaning_frame(random);
  c.fit_robustly(s);
  RC_ASSERT(is_plane(s));
  RC_ASSERT(farthest(c, s, 23) < 1e-6);
}

// Three in ten are too many for some draws. Measured: 99.6 % of them.
TEST(Fit, APlaneIsFoundExactlyInMostDrawsAmongThirtyPercentOutliers) {
  Random random(5);
  int exact = 0;
  for (int draw = 0; draw < 1000; ++draw) {
    const Cloudlet c = plane_with_outliers(random, 28, 8, 0.08);
    LocalSurface s = leaning_frame(random);
    c.fit_robustly(s);
    exact += is_plane(s) && farthest(c, s, 20) < 1e-6;
  }
  EXPECT_GT(exact, 980);
}

// Members round the top of a ball, or of a cylinder about the y axis.
Cloudlet on_top(double radius, bool cylinder, Random& random) {
  Cloudlet c;
  c.add({});
  while (c.points.size() < 28) {
    Vec3 p = in_disc(random, 2.5);
    const double out = cylinder ? p.x * p.x : squared_length(p);
    p.z = std::sqrt(radius * radius - out) - radius;
    c.add(p);
  }
  return c;
}

struct Deviation {
  double distance = 0, angle = 0;
};

// Of the fit at the members within one spacing of the centre, where it is used.
Deviation deviation_of(const Cloudlet& c, const LocalSurface& s, double radius, bool cylinder) {
  Deviation worst;
  for (Vec3 p : c.points) {
    if (squared_length(p) > 1) continue;
    const Vec3 out{p.x, cylinder ? 0 : p.y, p.z + radius};
    worst.distance = std::max(worst.distance, std::abs(s.distance(p)));
    worst.angle = std::max(worst.angle, length(cross(out, s.normal(p))) / length(out));
  }
  return worst;
}

// What a quadric leaves of a round surface is of the fourth order, 1 / (8 radius³) at a spacing;
// the ridge flattens it by a thousandth, 1 / (2000 radius).
TEST(Fit, AQuadricFollowsRoundSurfacesToTheFourthOrder) {
  for (const bool cylinder : {false, true})
    for (const double radius : {5., 10., 20., 40.}) {
      Random random(7);
      std::vector<double> distances, angles;
      for (int draw = 0; draw < 200; ++draw) {
        const Cloudlet c = on_top(radius, cylinder, random);
        LocalSurface s = tangent_plane({}, {0, 0, 1});
        c.fit_robustly(s);
        EXPECT_FALSE(is_plane(s)) << radius;
        const Deviation d = deviation_of(c, s, radius, cylinder);
        distances.push_back(d.distance);
        angles.push_back(d.angle);
      }
      std::sort(distances.begin(), distances.end());
      std::sort(angles.begin(), angles.end());
      const double fourth = 1 / (8 * radius * radius * radius), ridge = 1 / (2000 * radius);
      EXPECT_LT(distances[100], 4 * fourth + 2 * ridge) << radius;
      EXPECT_LT(distances[190], 8 * fourth + 3 * ridge) << radius;  // nineteen draws in twenty
      EXPECT_LT(angles[190], 12 * fourth + 6 * ridge) << radius;    // radians
    }
}

// What one patch left behind does not show in the next, and neither does when fits are asked for.
RC_GTEST_PROP(Fit, PatchesAndFitsInBetweenLeaveNoTrace, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Cloudlet before = plane_with_outliers(random, 30, 4, 0.08), c = on_top(6, false, random);
  const LocalSurface frame = leaning_frame(random);
  LocalSurface alone = frame, after = frame, between = frame;
  c.fit_robustly(alone);
  PatchFit fit;
  for (const Cloudlet* cloudlet : {&before, &c}) {
    fit.start(frame, 1, 0);
    for (std::size_t k = 0; k < cloudlet->points.size(); ++k) {
      fit.add(cloudlet->points[k], cloudlet->weight[k]);
      if (k % 5 == 4) fit.fit(k % 2 ? Form::plane : Form::quadric, between);
    }
    fit.fit_robustly(after);
  }
  RC_ASSERT(after.c == alone.c);
  RC_ASSERT(between.c != alone.c);
}

// Lengths are measured in spacings: the same patch at another scale has the same fit.
RC_GTEST_PROP(Fit, TheFitScalesWithTheSpacing, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const double scale = std::ldexp(1.0, *rc::gen::inRange(-40, 40));
  const Cloudlet one = on_top(8, *rc::gen::arbitrary<bool>(), random);
  Cloudlet other = one;
  for (Vec3& p : other.points) p = scale * p;
  LocalSurface s = leaning_frame(random), t = s;
  one.fit_robustly(s);
  other.fit_robustly(t, scale);
  for (std::size_t i = 0; i < one.points.size(); ++i)
    RC_ASSERT(t.distance(other.points[i]) == scale * s.distance(one.points[i]));
}

}  // namespace
}  // namespace arris
