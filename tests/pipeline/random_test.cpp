// Whatever the points: a certified mesh, or an error that says what is wrong with them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "pipeline/clouds.h"
#include "support/measure.h"
#include "support/random.h"

namespace arris {
namespace {

using namespace test;

using Maker = Vec3 (*)(Random&);

Vec3 in_cube(Random& random) {
  return {random.unit(), random.unit(), random.unit()};
}
// Many cospherical, coplanar and equal points.
Vec3 on_grid(Random& random) {
  return {static_cast<double>(random.below(4)), static_cast<double>(random.below(4)),
          static_cast<double>(random.below(4))};
}
// Four clusters, each a hundred million times smaller than their distance.
Vec3 in_clusters(Random& random) {
  const double x = static_cast<double>(random.below(2)), y = static_cast<double>(random.below(2));
  return Vec3{x, y, x + y} + 1e-8 * in_cube(random);
}
// Coordinates of every order of magnitude: slivers, needles, and spacings that underflow squared.
Vec3 of_all_scales(Random& random) {
  const auto coordinate = [&] {
    return (random.below(2) == 0 ? -1 : 1) * std::pow(10.0, -300 * random.unit());
  };
  return {coordinate(), coordinate(), coordinate()};
}
// A plane but for the last bits.
Vec3 nearly_flat(Random& random) {
  return {random.unit(), random.unit(), 1e-15 * random.unit()};
}
// Neighbouring doubles far from the origin: nothing fits between them.
Vec3 on_last_bits(Random& random) {
  constexpr double far = 0x1p53;
  return Vec3{far, far, far} + 2 * on_grid(random);
}

void certified_or_refused(Maker make, const Options& options = {}, std::size_t most = 200) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  std::vector<Vec3> points(*rc::gen::inRange<std::size_t>(4, most + 1));
  for (Vec3& p : points) p = make(random);
  const Result<Reconstruction> r = reconstruct(cloud_of(points), options);
  if (!r) {
    RC_LOG() << said(r) << '\n';
    const ErrorCode code = r.error().code;
    RC_ASSERT(code == ErrorCode::bad_points || code == ErrorCode::degenerate ||
              code == ErrorCode::no_surface);
    RC_ASSERT(!r.error().remedy.empty());
    return;
  }
  const Result<Certificate> again = check(r->mesh);
  RC_ASSERT(bool(again));
  RC_ASSERT(again->ok());
  require_manifold(r->mesh);
  for (std::size_t v = 0; v < r->mesh.vertices.size(); ++v) {
    const Index s = r->mesh.source[v];
    const bool in_place =
        s == no_index || r->report.moved_samples > 0 || r->mesh.vertices[v] == points[s];
    RC_ASSERT(in_place);
  }
}

RC_GTEST_PROP(RandomPoints, InACube, ()) {
  certified_or_refused(in_cube);
}
RC_GTEST_PROP(RandomPoints, OnAGrid, ()) {
  certified_or_refused(on_grid);
}
RC_GTEST_PROP(RandomPoints, InClusters, ()) {
  certified_or_refused(in_clusters);
}
RC_GTEST_PROP(RandomPoints, OfAllScales, ()) {
  certified_or_refused(of_all_scales, {}, 100);
}
RC_GTEST_PROP(RandomPoints, NearlyFlat, ()) {
  certified_or_refused(nearly_flat);
}
RC_GTEST_PROP(RandomPoints, OnTheLastBits, ()) {
  certified_or_refused(on_last_bits);
}

// With background points, which make it ten times slower.
constexpr std::size_t few = 60;

RC_GTEST_PROP(RandomPoints, InACubeByThePaper, ()) {
  certified_or_refused(in_cube, paper(), few);
}
RC_GTEST_PROP(RandomPoints, OnAGridByThePaper, ()) {
  certified_or_refused(on_grid, paper(), few);
}
RC_GTEST_PROP(RandomPoints, InClustersByThePaper, ()) {
  certified_or_refused(in_clusters, paper(), few);
}
RC_GTEST_PROP(RandomPoints, OfAllScalesByThePaper, ()) {
  certified_or_refused(of_all_scales, paper(), few);
}
RC_GTEST_PROP(RandomPoints, NearlyFlatByThePaper, ()) {
  certified_or_refused(nearly_flat, paper(), few);
}
RC_GTEST_PROP(RandomPoints, OnTheLastBitsByThePaper, ()) {
  certified_or_refused(on_last_bits, paper(), few);
}

}  // namespace
}  // namespace arris
