#include "truth/necks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "base/vec.h"
#include "surface/box_tree.h"
#include "surface/mesh_measure.h"
#include "truth/measure.h"
#include "truth/ray_caster.h"
#include "truth/samplers.h"

namespace arris::truth {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double chords = 3;  // of the ball tried: as of clearance, to which flatter bars are walls
constexpr double tip = 3;     // the same shape in a ball so much larger is no tip

// The part of the surface inside a ball that is joined to its middle.
class BallPart {
 public:
  explicit BallPart(const Mesh& mesh)
      : mesh_(mesh),
        edges_(edges(mesh)),
        edges_of_(mesh.triangles.size()),
        tree_(mesh.vertices, mesh.triangles, all_triangles(mesh), measuring_frame(mesh.vertices),
              1),
        joined_(mesh.triangles.size(), false) {
    std::vector<std::size_t> count(mesh.triangles.size(), 0);
    for (Index e = 0; e < edges_.size(); ++e)
      for (const Index t : {edges_[e].left, edges_[e].right}) edges_of_[t][count[t]++] = e;
  }

  // Faces less edges plus vertices: each of them meets the ball in one convex piece, so this is the
  // Euler characteristic of the part (its dual complex), 1 for a disc and for nothing else.
  bool is_disc(Vec3 p, double radius) {
    join(p, radius);
    long sum = 0;
    std::vector<Index> sides, corners;
    for (const Index t : reached_) {
      ++sum;
      joined_[t] = false;
      for (const Index e : edges_of_[t])
        if (crosses(e, p, radius)) sides.push_back(e);
      for (const Index v : mesh_.triangles[t])
        if (distance(mesh_.vertices[v], p) < radius) corners.push_back(v);
    }
    return sum - distinct(sides) + distinct(corners) == 1;
  }

 private:
  static long distinct(std::vector<Index>& values) {
    std::sort(values.begin(), values.end());
    return std::unique(values.begin(), values.end()) - values.begin();
  }

  bool crosses(Index e, Vec3 p, double radius) const {
    return distance_to_segment(p, mesh_.vertices[edges_[e].a], mesh_.vertices[edges_[e].b]) <
           radius;
  }

  // The triangle at p: the nearest.
  Index triangle_at(Vec3 p, double radius) const {
    arris::Box box;
    box.add(tree_.map(p - 1e-3 * Vec3{radius, radius, radius}));
    box.add(tree_.map(p + 1e-3 * Vec3{radius, radius, radius}));
    Index best = 0;
    double least = infinity;
    tree_.for_each_overlap(box, 0, [&](std::size_t position) {
      const Index t = tree_.triangle(position);
      const Triangle& c = mesh_.triangles[t];
      const double d =
          distance_to_triangle(p, mesh_.vertices[c[0]], mesh_.vertices[c[1]], mesh_.vertices[c[2]]);
      if (d < least) {
        least = d;
        best = t;
      }
    });
    return best;
  }

  void join(Vec3 p, double radius) {
    reached_.assign(1, triangle_at(p, radius));
    joined_[reached_[0]] = true;
    for (std::size_t k = 0; k < reached_.size(); ++k) {
      const Index t = reached_[k];
      for (const Index e : edges_of_[t]) {
        const Index next = edges_[e].left == t ? edges_[e].right : edges_[e].left;
        if (joined_[next] || !crosses(e, p, radius)) continue;
        joined_[next] = true;
        reached_.push_back(next);
      }
    }
  }

  const Mesh& mesh_;
  std::vector<Edge> edges_;
  std::vector<std::array<Index, 3>> edges_of_;
  BoxTree tree_;
  std::vector<Index> reached_;
  std::vector<bool> joined_;  // of those in reached_
};

}  // namespace

double measure_necks(const Mesh& mesh, double reach, std::size_t points) {
  const Samples samples = sample(mesh, {Mode::uniform, points, 1});
  const RayCaster rays(mesh);
  BallPart part(mesh);
  double least = infinity;
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (const double side : {-1.0, 1.0}) {
      const Vec3 p = samples.positions[i];
      const double limit = std::min(reach, least);
      const double radius =
          chords * rays.first_hit(p, side * samples.directions[i], limit / chords).distance;
      if (radius < limit && !part.is_disc(p, radius) && !part.is_disc(p, tip * radius))
        least = radius;
    }
  return least;
}

}  // namespace arris::truth
