#include "truth/thickness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/vec.h"
#include "truth/clearance.h"
#include "truth/feature_graph.h"
#include "truth/measure.h"
#include "truth/necks.h"
#include "truth/ray_caster.h"
#include "truth/samplers.h"

namespace arris::truth {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;
constexpr double across = 4;         // spacings across the thinnest part
constexpr double per_diagonal = 50;  // and across the diagonal, at least
constexpr double edge_step = 0.02;   // of the points tried for clearance, of the diagonal
constexpr std::size_t neck_points = 20000, quick_neck_points = 3000;
constexpr double detail_angle = 30 * pi / 180;

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
  return std::min({wall, gap, detail, clearance, neck});
}

Thickness measure_thickness(const Mesh& mesh) {
  constexpr std::size_t rays = 4000;
  constexpr double reach = across / per_diagonal;  // nothing beyond matters to dense_samples
  const double diagonal = bounds_of(mesh.vertices).diagonal();
  const Samples samples = sample(mesh, {Mode::uniform, rays, 1});
  const RayCaster caster(mesh);
  return {thin_quantile(caster, samples, -1), thin_quantile(caster, samples, 1),
          smallest_detail(mesh), measure_clearance(mesh, reach * diagonal, edge_step * diagonal),
          measure_necks(mesh, reach * diagonal, neck_points)};
}

bool has_thin_spots(const Mesh& mesh, double length) {
  const double step = edge_step * bounds_of(mesh.vertices).diagonal();
  return smallest_detail(mesh) < length || measure_clearance(mesh, length, step) < length ||
         measure_necks(mesh, length, quick_neck_points) < length;
}

std::size_t dense_samples(const Mesh& mesh, const Thickness& thickness) {
  const double widest = bounds_of(mesh.vertices).diagonal() / per_diagonal;
  return samples_at_spacing(area(mesh), std::min(thickness.thinnest() / across, widest));
}

}  // namespace arris::truth
