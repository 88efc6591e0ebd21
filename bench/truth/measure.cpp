#include "truth/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "base/vec.h"

namespace arris::truth {
namespace {

// The corners of the triangles round one vertex must chain into a single cycle.
bool is_one_fan(std::vector<std::pair<Index, Index>> links) {
  std::sort(links.begin(), links.end());
  const Index start = links.front().first;
  Index at = start;
  for (std::size_t step = 1; step <= links.size(); ++step) {
    const auto next = std::lower_bound(links.begin(), links.end(), std::pair{at, Index{0}});
    if (next == links.end() || next->first != at) return false;
    at = next->second;
    if (at == start) return step == links.size();
  }
  return false;
}

}  // namespace

std::vector<HalfEdge> sorted_half_edges(const Mesh& mesh) {
  std::vector<HalfEdge> result;
  result.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = corners[i], to = corners[(i + 1) % 3];
      result.push_back({std::min(from, to), std::max(from, to), from < to, static_cast<Index>(t)});
    }
  }
  std::sort(result.begin(), result.end(), [](const HalfEdge& l, const HalfEdge& r) {
    return std::array{l.a, l.b, Index{!l.forward}, l.triangle} <
           std::array{r.a, r.b, Index{!r.forward}, r.triangle};
  });
  return result;
}

double Bounds::diagonal() const {
  return distance(low, high);
}

Vec3 Bounds::centre() const {
  return 0.5 * (low + high);
}

Bounds bounds_of(const std::vector<Vec3>& points) {
  Bounds b{points.at(0), points.at(0)};
  for (const Vec3 p : points) {
    b.low = {std::min(b.low.x, p.x), std::min(b.low.y, p.y), std::min(b.low.z, p.z)};
    b.high = {std::max(b.high.x, p.x), std::max(b.high.y, p.y), std::max(b.high.z, p.z)};
  }
  return b;
}

std::vector<Edge> edges(const Mesh& mesh) {
  const std::vector<HalfEdge> half = sorted_half_edges(mesh);
  std::vector<Edge> result;
  result.reserve(half.size() / 2);
  for (std::size_t i = 0; i < half.size(); i += 2) {
    const auto same = [&](std::size_t j) {
      return j < half.size() && half[j].a == half[i].a && half[j].b == half[i].b;
    };
    if (!same(i + 1) || same(i + 2)) throw std::invalid_argument("an edge has not two triangles");
    if (!half[i].forward || half[i + 1].forward)
      throw std::invalid_argument("two triangles walk an edge the same way");
    result.push_back({half[i].a, half[i].b, half[i].triangle, half[i + 1].triangle});
  }
  return result;
}

void require_manifold(const Mesh& mesh) {
  edges(mesh);
  std::vector<std::vector<std::pair<Index, Index>>> links(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) links[t[i]].emplace_back(t[(i + 1) % 3], t[(i + 2) % 3]);
  for (auto& around : links)
    if (!around.empty() && !is_one_fan(std::move(around)))
      throw std::invalid_argument("the triangles round a vertex are not one fan");
}

Vec3 normal(const Mesh& mesh, Index triangle) {
  const Triangle& t = mesh.triangles[triangle];
  const Vec3 a = mesh.vertices[t[0]];
  return cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
}

double turn(const Mesh& mesh, const Edge& edge) {
  const Vec3 left = normal(mesh, edge.left), right = normal(mesh, edge.right);
  const Vec3 along = mesh.vertices[edge.b] - mesh.vertices[edge.a];
  return std::atan2(dot(cross(left, right), along) / length(along), dot(left, right));
}

double area(const Mesh& mesh) {
  double twice = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    twice += length(normal(mesh, static_cast<Index>(t)));
  return twice / 2;
}

double volume(const Mesh& mesh) {
  double six_times = 0;
  for (const Triangle& t : mesh.triangles)
    six_times += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]]));
  return six_times / 6;
}

double total_mean_curvature(const Mesh& mesh) {
  double sum = 0;
  for (const Edge& e : edges(mesh))
    sum += distance(mesh.vertices[e.a], mesh.vertices[e.b]) * std::abs(turn(mesh, e)) / 2;
  return sum;
}

std::size_t components(const Mesh& mesh) {
  std::vector<Index> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto root = [&](Index v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<bool> used(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles)
    for (const Index v : t) {
      used[v] = true;
      parent[root(v)] = root(t[0]);
    }
  std::size_t count = 0;
  for (std::size_t v = 0; v < parent.size(); ++v) count += used[v] && parent[v] == v;
  return count;
}

long euler(const Mesh& mesh) {
  std::vector<bool> used(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles)
    for (const Index v : t) used[v] = true;
  const auto vertices = std::count(used.begin(), used.end(), true);
  return static_cast<long>(vertices) - static_cast<long>(edges(mesh).size()) +
         static_cast<long>(mesh.triangles.size());
}

std::vector<Index> all_triangles(const Mesh& mesh) {
  std::vector<Index> indices(mesh.triangles.size());
  std::iota(indices.begin(), indices.end(), Index{0});
  return indices;
}

double distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 ab = b - a;
  const double s = std::clamp(dot(p - a, ab) / squared_length(ab), 0.0, 1.0);
  return distance(p, a + s * ab);
}

double distance_to_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return length(ap);
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return length(bp);
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return length(cp);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return length(ap - (d1 / (d1 - d3)) * ab);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return length(ap - (d2 / (d2 - d6)) * ac);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6)
    return length(bp - ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b));
  const Vec3 n = cross(ab, ac);
  return std::abs(dot(n, ap)) / length(n);
}

double distance_to_mesh(Vec3 p, const Mesh& mesh) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles)
    nearest = std::min(nearest, distance_to_triangle(p, mesh.vertices[t[0]], mesh.vertices[t[1]],
                                                     mesh.vertices[t[2]]));
  return nearest;
}

}  // namespace arris::truth
