#include "feature/normal_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "feature/rough_surface.h"
#include "support/creases.h"

namespace arris {
namespace {

using namespace test;

double degrees_between(Vec3 a, Vec3 b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

// Mean angle in degrees between normals and those of `truth`, over facets with a normal whose
// middle is `wanted`.
double mean_error(
    const RoughSurface& rough, const std::vector<Vec3>& normal,
    const std::function<Vec3(Vec3)>& truth,
    const std::function<bool(Vec3)>& wanted = [](Vec3) { return true; }) {
  double sum = 0, count = 0;
  for (std::size_t f = 0; f < normal.size(); ++f) {
    const Vec3 middle = rough.middle(f);
    if (normal[f] == Vec3{} || !wanted(middle)) continue;
    sum += degrees_between(normal[f], truth(middle));
    count += 1;
  }
  return sum / count;
}

// The outward normal of the face of a convex polyhedron, its centre at the origin, that a ray from
// there through p leaves through.
Vec3 face_normal(const Mesh& convex, Vec3 p) {
  Vec3 best{};
  double most = 0;
  for (const Triangle& t : convex.triangles) {
    const Vec3 a = convex.vertices[t[0]];
    Vec3 n = cross(convex.vertices[t[1]] - a, convex.vertices[t[2]] - a);
    n = 1 / length(n) * n;
    const double share = dot(n, p) / dot(n, a);
    if (share <= most) continue;
    most = share;
    best = n;
  }
  return best;
}

TEST(NormalFilter, FacesBecomeFlatAndEdgesStay) {
  const Shape shape = dodecahedron();  // turns by 63 degrees
  const Creases creases(shape.mesh);
  const RoughSurface rough(shape, 4000, 0.08);
  const auto truth = [&](Vec3 p) { return face_normal(shape.mesh, p); };
  const std::vector<Vec3> normal = filter_normals(rough.points, rough.facets, 1).normal;
  for (double near : {1.0, 2.0}) {  // beside the edges; inside the faces
    const auto wanted = [&](Vec3 p) {
      const double far = creases.distance_from(p) / rough.h;
      return near == 1.0 ? far > 0.5 && far < 1.5 : far > 2;
    };
    EXPECT_GT(mean_error(rough, rough.facets.normal, truth, wanted), 8) << near;
    EXPECT_LT(mean_error(rough, normal, truth, wanted), near == 1.0 ? 4 : 2) << near;
  }
}

TEST(NormalFilter, RoundSurfacesStayRound) {
  const RoughSurface rough(sphere(), 2000, 0.1);
  const auto truth = [](Vec3 p) { return 1 / length(p) * p; };
  const FilteredNormals filtered = filter_normals(rough.points, rough.facets, 1);
  EXPECT_GT(mean_error(rough, rough.facets.normal, truth), 10);
  EXPECT_LT(mean_error(rough, filtered.normal, truth), 4.5);
  for (std::size_t f = 0; f < filtered.normal.size(); ++f)
    EXPECT_NEAR(length(filtered.normal[f]), 1, 1e-12);
}

TEST(NormalFilter, ExactFacesKeepTheirNormal) {
  const RoughSurface exact(cube(), 2000, 0);
  const auto on_top = [](Vec3 p) {
    return p.z > 1 - 1e-9 && std::min({p.x, p.y, 1 - p.x, 1 - p.y}) > 0.3;
  };
  const auto up = [](Vec3) { return Vec3{0, 0, 1}; };
  const std::vector<Vec3> normal = filter_normals(exact.points, exact.facets, 1).normal;
  EXPECT_LT(mean_error(exact, normal, up, on_top), 0.3);
}

TEST(NormalFilter, ThreadsDoNotChangeABit) {
  const RoughSurface rough(cube(), 6000, 0.1);
  EXPECT_EQ(filter_normals(rough.points, rough.facets, 1).normal,
            filter_normals(rough.points, rough.facets, 4).normal);
}

}  // namespace
}  // namespace arris
