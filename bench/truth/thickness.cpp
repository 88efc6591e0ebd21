#include "truth/thickness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/vec.h"
#include "surface/box_tree.h"
#include "surface/mesh_measure.h"
#include "truth/clearance.h"
#include "truth/feature_graph.h"
#include "truth/measure.h"
#include "truth/samplers.h"

namespace arris::truth {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;
constexpr double across = 4;         // spacings across the thinnest part
constexpr double per_diagonal = 50;  // and across the diagonal, at least
constexpr double edge_step = 0.02;   // of the points tried for clearance, of the diagonal
constexpr double detail_angle = 30 * pi / 180;

struct Hit {
  double distance = infinity;
  Vec3 normal;  // unit
};

// The first hit of rays with a mesh. A ray is followed in stretches of doubling length, so that
// only triangles near it are looked at.
class RayCaster {
 public:
  explicit RayCaster(const Mesh& mesh)
      : mesh_(mesh),
        diagonal_(bounds_of(mesh.vertices).diagonal()),
        tree_(mesh.vertices, mesh.triangles, all(mesh.triangles.size()),
              measuring_frame(mesh.vertices), 1) {}

  // Hits nearer than a millionth of the diagonal are the start itself.
  Hit first_hit(Vec3 from, Vec3 direction) const {
    double begin = 1e-6 * diagonal_, end = 0.02 * diagonal_;
    for (; begin < diagonal_; begin = end, end *= 2) {
      const Hit hit = nearest_between(from, direction, begin, end);
      if (hit.distance < infinity) return hit;
    }
    return {};
  }

 private:
  static std::vector<Index> all(std::size_t n) {
    std::vector<Index> indices(n);
    std::iota(indices.begin(), indices.end(), Index{0});
    return indices;
  }

  Hit nearest_between(Vec3 from, Vec3 direction, double begin, double end) const {
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
  double distance_along(Vec3 from, Vec3 direction, const Triangle& t) const {
    const Vec3 a = mesh_.vertices[t[0]];
    const Vec3 ab = mesh_.vertices[t[1]] - a, ac = mesh_.vertices[t[2]] - a;
    const Vec3 p = cross(direction, ac), s = from - a, q = cross(s, ab);
    const double det = dot(ab, p);
    if (det == 0) return infinity;
    const double u = dot(s, p) / det, v = dot(direction, q) / det;
    return u < 0 || v < 0 || u + v > 1 ? infinity : dot(ac, q) / det;
  }

  const Mesh& mesh_;
  double diagonal_;
  BoxTree tree_;
};

// The length that one percent of all rays fall short of, along side * direction.
double thin_quantile(const RayCaster& rays, const Samples& samples, double side) {
  constexpr double share = 0.01;
  const double parallel = std::cos(15 * pi / 180);
  std::vector<double> lengths;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3 n = samples.directions[i];
    const Hit hit = rays.first_hit(samples.positions[i], side * n);
    const bool wall = hit.distance < infinity && dot(hit.normal, n) < -parallel;
    lengths.push_back(wall ? hit.distance : infinity);
  }
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(lengths.size()));
  std::nth_element(lengths.begin(), lengths.begin() + at, lengths.end());
  return lengths[static_cast<std::size_t>(at)];
}

// Sets of vertices that are joined, and the smallest diagonal of their bounding boxes.
class Groups {
 public:
  explicit Groups(std::size_t vertices) : parent_(vertices) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  void join(Index a, Index b) { parent_[root(a)] = root(b); }

  // Of the groups of more than one vertex.
  double smallest(const std::vector<Vec3>& points) {
    std::vector<Bounds> bounds(points.size());
    std::vector<Index> members(points.size(), 0);
    for (Index v = 0; v < points.size(); ++v) {
      const Index r = root(v);
      const Vec3 p = points[v];
      Bounds& b = bounds[r];
      b = members[r]++ == 0 ? Bounds{p, p} : bounds_of({b.low, b.high, p});
    }
    double result = infinity;
    for (std::size_t r = 0; r < points.size(); ++r)
      if (members[r] > 1) result = std::min(result, bounds[r].diagonal());
    return result;
  }

 private:
  Index root(Index v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  std::vector<Index> parent_;
};

double smallest_detail(const Mesh& mesh) {
  Groups components(mesh.vertices.size()), creases(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    components.join(t[0], t[1]);
    components.join(t[1], t[2]);
  }
  for (const SharpEdge& e : feature_graph(mesh, detail_angle).sharp) creases.join(e.a, e.b);
  return std::min(components.smallest(mesh.vertices), creases.smallest(mesh.vertices));
}

}  // namespace

double Thickness::thinnest() const {
  return std::min({wall, gap, detail, clearance});
}

Thickness measure_thickness(const Mesh& mesh) {
  constexpr std::size_t rays = 4000;
  constexpr double reach = across / per_diagonal;  // nothing beyond matters to dense_samples
  const double diagonal = bounds_of(mesh.vertices).diagonal();
  const Samples samples = sample(mesh, {Mode::uniform, rays, 1});
  const RayCaster caster(mesh);
  return {thin_quantile(caster, samples, -1), thin_quantile(caster, samples, 1),
          smallest_detail(mesh), measure_clearance(mesh, reach * diagonal, edge_step * diagonal)};
}

bool has_thin_spots(const Mesh& mesh, double length) {
  const double step = edge_step * bounds_of(mesh.vertices).diagonal();
  return smallest_detail(mesh) < length || measure_clearance(mesh, length, step) < length;
}

std::size_t dense_samples(const Mesh& mesh, const Thickness& thickness) {
  const double widest = bounds_of(mesh.vertices).diagonal() / per_diagonal;
  return samples_at_spacing(area(mesh), std::min(thickness.thinnest() / across, widest));
}

}  // namespace arris::truth
