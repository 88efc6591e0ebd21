#include "feature/facets.h"

#include <algorithm>
#include <cmath>

#include "base/distinct.h"
#include "base/failure.h"
#include "base/parallel.h"
#include "base/triangle.h"
#include "base/vec.h"

namespace arris {
namespace {

// A facet whose height is below this share of its longest side has no normal to judge by: a
// position off by a hundredth of a side would turn it by four degrees.
constexpr double sliver = 0.15;

// The facet that has the directed side a -> b. In the smaller star: over all sides of a graph of
// bounded genus these sum to O(sides) (Chiba, Nishizeki, "Arboricity and subgraph listing
// algorithms", 1985).
Index facet_with_side(const FacetMesh& mesh, Index a, Index b) {
  for (Index f : mesh.star(a).size() <= mesh.star(b).size() ? mesh.star(a) : mesh.star(b))
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
  parallel_for(facets.size(), threads, [&](std::size_t f) {
    const Triangle& t = facets[f];
    normal[f] = unit_normal(t, points);
    for (std::size_t i = 0; i < 3; ++i)
      neighbours[f][i] = facet_with_side(*this, t[(i + 2) % 3], t[(i + 1) % 3]);
  });
}

std::span<const Index> FacetMesh::star_near(Index v, Index facet,
                                            std::vector<Index>& buffer) const {
  const auto all = star(v);
  if (all.size() <= most_round) return all;
  buffer.assign(1, facet);
  for (const std::size_t way : {1u, 2u}) {  // facets are oriented alike: the same side leads on
    Index f = facet;
    for (std::size_t step = 0; step < most_round / 2; ++step) {
      f = neighbours[f][(corner_of(facets[f], v) + way) % 3];
      buffer.push_back(f);
    }
  }
  keep_distinct(buffer);
  return buffer;
}

double angle_at(const std::vector<Vec3>& points, const Triangle& facet, Index v) {
  const Vec3 a = points[next_corner(facet, v)] - points[v];
  const Vec3 b = points[previous_corner(facet, v)] - points[v];
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
  std::vector<Index> buffer;
  for (Index f : mesh.star(v)) {
    const Index w = next_corner(mesh.facets[f], v);
    if (seen.insert(w)) out.push_back(w);
    for (Index g : mesh.star_near(w, f, buffer)) {
      const Index x = next_corner(mesh.facets[g], w);
      if (seen.insert(x)) out.push_back(x);
    }
  }
  std::sort(out.begin(), out.end());
}

void keep_nearest(const std::vector<Vec3>& points, Index v, std::size_t most,
                  std::vector<Index>& list) {
  if (list.size() <= most) return;
  const auto far = [&](Index w) { return squared_length(points[w] - points[v]); };
  std::nth_element(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(most), list.end(),
                   [&](Index a, Index b) {
                     const double p = far(a), q = far(b);
                     return p != q ? p < q : a < b;
                   });
  list.resize(most);
  std::sort(list.begin(), list.end());
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

void spread(const std::vector<Triangle>& facets, int rings, std::vector<std::uint8_t>& marked) {
  for (int round = 0; round < rings; ++round) {
    const std::vector<std::uint8_t> before = marked;
    for (const Triangle& t : facets)
      if (before[t[0]] || before[t[1]] || before[t[2]])
        for (Index v : t) marked[v] = 1;
  }
}

}  // namespace arris
