#include "truth/ray_caster.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/vec.h"
#include "surface/mesh_measure.h"
#include "truth/measure.h"

namespace arris::truth {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

RayCaster::RayCaster(const Mesh& mesh)
    : mesh_(mesh),
      diagonal_(bounds_of(mesh.vertices).diagonal()),
      tree_(mesh.vertices, mesh.triangles, all_triangles(mesh), measuring_frame(mesh.vertices), 1) {
}

Hit RayCaster::first_hit(Vec3 from, Vec3 direction, double limit) const {
  double begin = 1e-6 * diagonal_, end = 0.02 * diagonal_;
  for (; begin < std::min(diagonal_, limit); begin = end, end *= 2) {
    const Hit hit = nearest_between(from, direction, begin, end);
    if (hit.distance < infinity) return hit;
  }
  return {};
}

Hit RayCaster::nearest_between(Vec3 from, Vec3 direction, double begin, double end) const {
  arris::Box stretch;
  stretch.add(tree_.map(from + begin * direction));
  stretch.add(tree_.map(from + end * direction));
  Hit nearest;
  tree_.for_each_overlap(stretch, 0, [&](std::size_t position) {
    const Index t = tree_.triangle(position);
    const double d = distance_along(from, direction, mesh_.triangles[t]);
    if (d < begin || d > end || d >= nearest.distance) return;
    const Vec3 n = normal(mesh_, t);
    nearest = {d, (1 / length(n)) * n};
  });
  return nearest;
}

// Moller and Trumbore 1997; infinity if the line misses the triangle.
double RayCaster::distance_along(Vec3 from, Vec3 direction, const Triangle& t) const {
  const Vec3 a = mesh_.vertices[t[0]];
  const Vec3 ab = mesh_.vertices[t[1]] - a, ac = mesh_.vertices[t[2]] - a;
  const Vec3 p = cross(direction, ac), s = from - a, q = cross(s, ab);
  const double det = dot(ab, p);
  if (det == 0) return infinity;
  const double u = dot(s, p) / det, v = dot(direction, q) / det;
  return u < 0 || v < 0 || u + v > 1 ? infinity : dot(ac, q) / det;
}

}  // namespace arris::truth
