#include "compare/pairs.h"

#include <utility>

#include "base/vec.h"
#include "support/random.h"
#include "support/shapes.h"

namespace arris::test {
namespace {

Mesh shifted(Mesh mesh, Vec3 shift) {
  for (Vec3& p : mesh.vertices) p = p + shift;
  return mesh;
}

// Every vertex moved by normal noise in each coordinate.
Mesh shaken(Mesh mesh, double sigma, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& p : mesh.vertices)
    p = p + Vec3{sigma * random.normal(), sigma * random.normal(), sigma * random.normal()};
  return mesh;
}

// The unit cube with every edge cut off at 45 degrees.
Mesh bevelled_cube(double cut) {
  std::vector<Vec3> points;
  for (const double x : {0.0, 1.0})
    for (const double y : {0.0, 1.0})
      for (const double z : {0.0, 1.0}) {
        const auto in = [cut](double c) { return c == 0 ? cut : 1 - cut; };
        points.push_back({x, in(y), in(z)});
        points.push_back({in(x), y, in(z)});
        points.push_back({in(x), in(y), z});
      }
  return convex_hull(points);
}

// Without its last triangles.
Mesh opened(Mesh mesh, std::size_t missing) {
  mesh.triangles.resize(mesh.triangles.size() - missing);
  return mesh;
}

Mesh scaled(Mesh mesh, double factor) {
  for (Vec3& p : mesh.vertices) p = factor * p;
  return mesh;
}

// Both walked inwards.
Mesh reversed(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace

std::vector<Pair> comparison_pairs() {
  return {
      {"shifted_cube", shifted(cube().mesh, {0.01, 0.006, 0.003}), cube().mesh},
      {"bevelled_cube", bevelled_cube(0.02), cube().mesh},
      {"shaken_torus", shaken(torus().mesh, 0.004, 1), torus().mesh},
      {"ball_for_dodecahedron", scaled(sphere().mesh, 1.2), dodecahedron().mesh},
      {"moved_frames", moved(tangled_frames().mesh, 3, 1, {5, 5, 5}),
       moved(tangled_frames().mesh, 3, 1, {5.02, 5, 4.99})},
      {"open_bracket", opened(shaken(l_bracket().mesh, 0.01, 2), 3), l_bracket().mesh},
      {"inside_out_steps", reversed(scaled(steps().mesh, 1.004)), steps().mesh},
      {"shell_without_core", nested_shells().mesh,
       scaled(box_complex({{{0, 0, 0}, {5, 5, 5}}}), 1)},
  };
}

}  // namespace arris::test
