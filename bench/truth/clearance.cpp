#include "truth/clearance.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "base/vec.h"
#include "surface/box_tree.h"
#include "surface/mesh_measure.h"
#include "truth/measure.h"
#include "truth/samplers.h"

namespace arris::truth {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double detour = 3;  // parts joined within so many distances belong together

// Per triangle the three across its edges.
std::vector<std::array<Index, 3>> neighbours_of(const Mesh& mesh) {
  std::vector<std::array<Index, 3>> result(mesh.triangles.size());
  const auto set = [&](Index t, const Edge& e, Index other) {
    const Triangle& corners = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i)
      if (corners[i] != e.a && corners[i] != e.b) result[t][(i + 1) % 3] = other;
  };
  for (const Edge& e : edges(mesh)) {
    set(e.left, e, e.right);
    set(e.right, e, e.left);
  }
  return result;
}

// Searches from one point at a time.
class Search {
 public:
  explicit Search(const Mesh& mesh)
      : mesh_(mesh),
        neighbours_(neighbours_of(mesh)),
        tree_(mesh.vertices, mesh.triangles, all_triangles(mesh), measuring_frame(mesh.vertices),
              1),
        grain_(1e-9 * bounds_of(mesh.vertices).diagonal()),
        distance_(mesh.triangles.size(), infinity),
        joined_(mesh.triangles.size(), false) {}

  // The clearance of p if it is less than `reach`, else infinity.
  double at(Vec3 p, double reach) {
    find_near(p, reach);
    if (near_.empty()) return infinity;
    const double result = join(p);
    for (const Index t : near_) distance_[t] = infinity;
    for (const Index t : reached_) joined_[t] = false;
    return result;
  }

 private:
  // An edge at `radius` from the point, through which triangle `t` is reached.
  using Door = std::pair<double, Index>;

  // The triangles within reach, nearest first.
  void find_near(Vec3 p, double reach) {
    near_.clear();
    arris::Box box;
    box.add(tree_.map(p - Vec3{reach, reach, reach}));
    box.add(tree_.map(p + Vec3{reach, reach, reach}));
    tree_.for_each_overlap(box, 0, [&](std::size_t position) {
      const Index t = tree_.triangle(position);
      const Triangle& c = mesh_.triangles[t];
      const double d =
          distance_to_triangle(p, mesh_.vertices[c[0]], mesh_.vertices[c[1]], mesh_.vertices[c[2]]);
      if (d >= reach) return;
      distance_[t] = d;
      near_.push_back(t);
    });
    std::sort(near_.begin(), near_.end(), [&](Index l, Index r) {
      return std::pair(distance_[l], l) < std::pair(distance_[r], r);
    });
  }

  // Grows the ball round p and with it the surface that is joined to p inside it (Dijkstra, with
  // the farthest door of a way for its length). Returns the distance of the nearest triangle that
  // is not reached by `detour` times its distance.
  double join(Vec3 p) {
    reached_.clear();
    std::priority_queue<Door, std::vector<Door>, std::greater<>> doors;
    doors.push({0, near_.front()});
    double radius = 0;
    for (const Index t : near_) {
      while (!joined_[t]) {
        if (doors.empty()) return distance_[t];
        radius = std::max(radius, doors.top().first);
        if (radius > detour * distance_[t] + grain_) return distance_[t];
        const Index next = doors.top().second;
        doors.pop();
        if (!joined_[next]) enter(p, next, doors);
      }
    }
    return infinity;
  }

  template <class Queue>
  void enter(Vec3 p, Index t, Queue& doors) {
    joined_[t] = true;
    reached_.push_back(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const Index next = neighbours_[t][i];
      if (joined_[next]) continue;
      const Vec3 a = mesh_.vertices[mesh_.triangles[t][i]];
      const Vec3 b = mesh_.vertices[mesh_.triangles[t][(i + 1) % 3]];
      doors.push({distance_to_segment(p, a, b), next});
    }
  }

  const Mesh& mesh_;
  std::vector<std::array<Index, 3>> neighbours_;
  BoxTree tree_;
  double grain_;  // points lie on the surface up to this
  std::vector<Index> near_, reached_;
  std::vector<double> distance_;  // of the triangles in near_
  std::vector<bool> joined_;      // of those in reached_
};

}  // namespace

double measure_clearance(const Mesh& mesh, double reach, double step) {
  constexpr std::size_t uniform_points = 1500;
  Search search(mesh);
  double least = infinity;
  const auto try_all = [&](const std::vector<Vec3>& points) {
    for (const Vec3 p : points) least = std::min(least, search.at(p, std::min(reach, least)));
  };
  try_all(feature_points(mesh, step));
  try_all(sample_uniform(mesh, uniform_points, 1));
  return least;
}

}  // namespace arris::truth
