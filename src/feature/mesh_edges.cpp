#include "feature/mesh_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/memory.h"
#include "base/parallel.h"
#include "base/vec.h"

namespace arris {
namespace {

// A triangle whose height is below this share of its longest edge is a needle: three samples along
// one line, of which rounding or a trace of noise decides the plane.
constexpr double needle_height = 0.02;

// Needles may lie side by side; as many steps lead out of them.
constexpr int needle_rounds = 4;

// One side of a triangle, to be sorted next to its twins.
struct Side {
  std::uint64_t key;  // the ends, lower one first
  Index face;
  std::uint8_t corner;
};

std::vector<Side> sorted_sides(const Mesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      if (a == b) continue;
      sides.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), static_cast<Index>(t),
                       static_cast<std::uint8_t>(k)});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.key != b.key ? a.key < b.key : a.face < b.face;
  });
  return sides;
}

void collect_stars(std::size_t vertices, MeshEdges& result) {
  result.star_begin.assign(vertices + 1, 0);
  for (const MeshEdge& e : result.edges)
    for (Index v : e.ends) ++result.star_begin[v + 1];
  std::partial_sum(result.star_begin.begin(), result.star_begin.end(), result.star_begin.begin());
  result.star.resize(result.star_begin.back());
  std::vector<std::size_t> next(result.star_begin.begin(), result.star_begin.end() - 1);
  for (std::size_t e = 0; e < result.edges.size(); ++e)
    for (Index v : result.edges[e].ends) result.star[next[v]++] = static_cast<Index>(e);
}

// Corner k of triangle t and the two after it.
std::array<Vec3, 3> corners_from(const Mesh& mesh, std::size_t t, std::size_t k) {
  const Triangle& c = mesh.triangles[t];
  return {mesh.vertices[c[k]], mesh.vertices[c[(k + 1) % 3]], mesh.vertices[c[(k + 2) % 3]]};
}

// Which side of triangle t the edge is, 0 to 2.
std::size_t side_of(const MeshEdges& edges, Index t, Index e) {
  const auto& sides = edges.of_face[t];
  return sides[0] == e ? 0 : sides[1] == e ? 1 : 2;
}

// Triangle t walks the edge from its lower end to the higher.
bool walks_upwards(const Mesh& mesh, const MeshEdges& edges, Index t, Index e) {
  return mesh.triangles[t][side_of(edges, t, e)] == edges.edges[e].ends[0];
}

// The cotangent of the angle of triangle t opposite edge e; 0 without area.
double opposite_cotangent(const Mesh& mesh, const MeshEdges& edges, Index t, Index e) {
  const auto x = corners_from(mesh, t, side_of(edges, t, e));
  const Vec3 a = x[0] - x[2], b = x[1] - x[2];
  const double twice_area = length(cross(a, b));
  return twice_area > 0 ? dot(a, b) / twice_area : 0;
}

double turning_of(const Mesh& mesh, const MeshEdges& edges, const std::vector<Vec3>& normals,
                  Index e) {
  const MeshEdge& edge = edges.edges[e];
  const Vec3 a = normals[edge.faces[0]];
  Vec3 b = normals[edge.faces[1]];
  const bool upwards = walks_upwards(mesh, edges, edge.faces[0], e);
  if (upwards == walks_upwards(mesh, edges, edge.faces[1], e)) b = -b;  // misoriented
  if (squared_length(a) == 0 || squared_length(b) == 0) return 0;
  const Vec3 turn = cross(a, b), up = mesh.vertices[edge.ends[1]] - mesh.vertices[edge.ends[0]];
  const double angle = std::atan2(length(turn), dot(a, b));
  return (dot(turn, up) < 0) == upwards ? -angle : angle;
}

}  // namespace

std::vector<Vec3> stable_normals(const Mesh& mesh, const MeshEdges& edges) {
  const std::size_t n = mesh.triangles.size();
  std::vector<Vec3> normals(n);
  std::vector<Index> needles, across(n, no_index);
  std::vector<std::uint8_t> is_needle(n, 0);
  for (std::size_t t = 0; t < n; ++t) {
    const auto x = corners_from(mesh, t, 0);
    const Vec3 normal = cross(x[1] - x[0], x[2] - x[0]);
    normals[t] = normalized(normal);
    Index longest = no_index;
    for (Index e : edges.of_face[t])
      if (e != no_index &&
          (longest == no_index || edges.edges[e].length > edges.edges[longest].length))
        longest = e;
    if (longest == no_index) continue;
    const MeshEdge& edge = edges.edges[longest];
    if (length(normal) >= needle_height * edge.length * edge.length) continue;
    is_needle[t] = 1;
    needles.push_back(static_cast<Index>(t));
    across[t] = edge.faces[edge.faces[0] == t ? 1 : 0];
  }
  for (int round = 0; round < needle_rounds; ++round)
    for (Index t : needles)
      if (is_needle[t] && across[t] != no_index && !is_needle[across[t]]) {
        normals[t] = normals[across[t]];
        is_needle[t] = 0;
      }
  return normals;
}

MeshEdges collect_edges(const Mesh& mesh, Job& job) {
  MeshEdges result;
  std::vector<Side> sides = sorted_sides(mesh);
  job.tick(0.2);
  result.of_face.assign(mesh.triangles.size(), {no_index, no_index, no_index});
  std::vector<std::uint8_t> branches;  // three or more triangles
  branches.reserve(sides.size() / 2);  // exactly, on a closed surface
  result.edges.reserve(sides.size() / 2);
  for (std::size_t begin = 0, end; begin < sides.size(); begin = end) {
    MeshEdge edge;
    edge.ends = {static_cast<Index>(sides[begin].key >> 32), static_cast<Index>(sides[begin].key)};
    edge.faces = {sides[begin].face, no_index};
    edge.length = distance(mesh.vertices[edge.ends[0]], mesh.vertices[edge.ends[1]]);
    for (end = begin; end < sides.size() && sides[end].key == sides[begin].key; ++end)
      result.of_face[sides[end].face][sides[end].corner] = static_cast<Index>(result.edges.size());
    if (end - begin > 1) edge.faces[1] = sides[begin + 1].face;
    branches.push_back(end - begin > 2);
    result.edges.push_back(edge);
  }
  release(sides);
  collect_stars(mesh.vertices.size(), result);
  job.tick(0.3);
  const std::vector<Vec3> normals = stable_normals(mesh, result);
  parallel_for(result.edges.size(), job.threads(), [&](std::size_t k) {
    MeshEdge& edge = result.edges[k];
    const auto e = static_cast<Index>(k);
    if (edge.faces[1] == no_index) return;
    edge.turning = branches[k] ? std::numbers::pi : turning_of(mesh, result, normals, e);
    edge.dual = std::max(0.0, 0.5 * edge.length *
                                  (opposite_cotangent(mesh, result, edge.faces[0], e) +
                                   opposite_cotangent(mesh, result, edge.faces[1], e)));
  });
  return result;
}

}  // namespace arris
