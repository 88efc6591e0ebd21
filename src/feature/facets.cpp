#include "feature/facets.h"

#include <algorithm>
#include <cmath>

#include "base/distinct.h"
#include "base/failure.h"
#include "base/parallel.h"
#include "base/vec.h"

namespace arris {
namespace {

// A facet whose height is below this share of its longest side has no normal to judge by: a
// position off by a hundredth of a side would turn it by four degrees.
constexpr double sliver = 0.15;

// The facet that has the directed side a -> b.
Index facet_with_side(const FacetMesh& mesh, Index a, Index b) {
  for (Index f : mesh.star(a))
    for (std::size_t i = 0; i < 3; ++i)
      if (mesh.facets[f][i] == a && mesh.facets[f][(i + 1) % 3] == b) return f;
  throw Failure(ErrorCode::internal, "a surface to sense features on is not closed",
                "please report it with the input");
}

Vec3 unit_normal(const Triangle& t, const std::vector<Vec3>& points) {
  const Vec3 a = points[t[0]], b = points[t[1]], c = points[t[2]];
  const Vec3 n = cross(b - a, c - a);
  const double area = length(n);
  const double longest =
      std::max({squared_length(b - a), squared_length(c - b), squared_length(a - c)});
  return area > sliver * longest ? (1 / area) * n : Vec3{};
}

}  // namespace

FacetMesh::FacetMesh(std::vector<Triangle> triangles, const std::vector<Vec3>& points,
                     unsigned threads)
    : facets(std::move(triangles)), stars(points.size(), facets) {
  neighbours.resize(facets.size());
  normal.resize(facets.size());
  middle.resize(facets.size());
  parallel_for(facets.size(), threads, [&](std::size_t f) {
    const Triangle& t = facets[f];
    normal[f] = unit_normal(t, points);
    middle[f] = 1.0 / 3 * (points[t[0]] + points[t[1]] + points[t[2]]);
    for (std::size_t i = 0; i < 3; ++i)
      neighbours[f][i] = facet_with_side(*this, t[(i + 2) % 3], t[(i + 1) % 3]);
  });
}

double angle_at(const std::vector<Vec3>& points, const Triangle& facet, Index v) {
  const std::size_t i = facet[0] == v ? 0 : facet[1] == v ? 1 : 2;
  const Vec3 a = points[facet[(i + 1) % 3]] - points[v], b = points[facet[(i + 2) % 3]] - points[v];
  return std::atan2(length(cross(a, b)), dot(a, b));
}

void ring(const FacetMesh& mesh, Index v, std::vector<Index>& out) {
  out.clear();
  for (Index f : mesh.star(v)) out.push_back(next_corner(mesh.facets[f], v));
  keep_distinct(out);
}

void two_rings(const FacetMesh& mesh, Index v, SmallSet& seen, std::vector<Index>& out) {
  out.clear();
  seen.clear();
  seen.insert(v);
  for (Index f : mesh.star(v)) {
    const Index w = next_corner(mesh.facets[f], v);
    if (seen.insert(w)) out.push_back(w);
    for (Index g : mesh.star(w)) {
      const Index x = next_corner(mesh.facets[g], w);
      if (seen.insert(x)) out.push_back(x);
    }
  }
  std::sort(out.begin(), out.end());
}

std::vector<std::uint8_t> at_bends(const FacetMesh& mesh, double angle, std::size_t points) {
  std::vector<std::uint8_t> marked(points, 0);
  const double cosine = std::cos(angle);
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
    for (Index g : mesh.neighbours[f])
      if (dot(mesh.normal[f], mesh.normal[g]) < cosine)  // slivers too
        for (Index v : mesh.facets[f]) marked[v] = 1;
  return marked;
}

void spread(const FacetMesh& mesh, int rings, std::vector<std::uint8_t>& marked) {
  for (int round = 0; round < rings; ++round) {
    const std::vector<std::uint8_t> before = marked;
    for (const Triangle& t : mesh.facets)
      if (before[t[0]] || before[t[1]] || before[t[2]])
        for (Index v : t) marked[v] = 1;
  }
}

}  // namespace arris
