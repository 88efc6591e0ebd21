#include "surface/component_orientation.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "base/triangle.h"
#include "base/vec.h"
#include "tetra/predicates.h"

namespace arris {
namespace {

using Points = std::span<const Vec3>;
using Triangles = std::span<const Triangle>;

// The lexicographically lowest vertex of a component, and the first triangle of the component.
struct Lowest {
  Index vertex = no_index;
  Index triangle = no_index;
};

std::vector<Lowest> find_lowest(Points points, Triangles triangles, const MeshTopology& topology) {
  std::vector<Lowest> lowest(topology.components);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Lowest& low = lowest[topology.component[t]];
    if (low.triangle == no_index) low = {triangles[t][0], static_cast<Index>(t)};
    for (Index v : triangles[t])
      if (lexicographic_less(points[v], points[low.vertex])) low.vertex = v;
  }
  return lowest;
}

// The corners after and before v, in the order the triangle walks them.
std::array<Index, 2> others(const Triangle& t, Index v) {
  return {next_corner(t, v), previous_corner(t, v)};
}

// A neighbour u of v, the lexicographically lowest vertex, such that the ray vu is an extreme ray
// of the cone of all edges at v. As all edges point to a half-space with only part of its boundary,
// angles round the z direction are totally ordered: u lies in the vertical plane that supports the
// cone on its clockwise side, and is the lowest there.
Index extreme_neighbour(Points points, Triangles triangles, std::span<const Index> star, Index v) {
  const Vec3 p = points[v];
  Index best = no_index;
  for (Index t : star) {
    const Index w = others(triangles[t], v)[0];
    if (points[w].x == p.x && points[w].y == p.y) continue;  // vertical: at no angle
    if (best == no_index || orient2d(p, points[best], points[w], 2) < 0) best = w;
  }
  const Index plane = best;
  const bool along_x = points[plane].x != p.x;  // horizontal coordinate within the plane
  for (Index t : star) {
    const Index w = others(triangles[t], v)[0];
    if (orient2d(p, points[plane], points[w], 2) != 0) continue;
    const int turn = orient2d(p, points[best], points[w], along_x ? 1 : 0);
    if (along_x ? turn > 0 : turn < 0) best = w;  // the zx plane is seen from behind
  }
  return best;
}

// At the lowest vertex and an extreme edge there the surface is convex, so the two triangles at the
// edge tell outside from inside: +1 if normals point outwards, -1 inwards.
int facing(Points points, Triangles triangles, std::span<const Index> star, Index v) {
  const Index u = extreme_neighbour(points, triangles, star, v);
  Index after = u, before = u;  // third corners of the triangles that walk v -> u and u -> v
  for (Index t : star) {
    const auto [next, previous] = others(triangles[t], v);
    if (next == u) after = previous;
    if (previous == u) before = next;
  }
  return -orient3d(points[v], points[u], points[after], points[before]);
}

// Side of the line pq (seen along x) on which c lies after a shift by (epsilon, epsilon^2) in y and
// z for an infinitely small epsilon: never 0 unless p and q coincide in the projection.
int shifted_side(Vec3 p, Vec3 q, Vec3 c) {
  const int side = orient2d(p, q, c, 0);
  if (side != 0) return side;
  if (p.z != q.z) return p.z > q.z ? 1 : -1;
  return p.y == q.y ? 0 : p.y < q.y ? 1 : -1;
}

// The ray from c towards lower x, shifted as above, passes through triangle abc, on which the
// origin does not lie.
bool ray_crosses(Vec3 a, Vec3 b, Vec3 d, Vec3 c) {
  const int turn = shifted_side(a, b, c);
  if (turn == 0 || shifted_side(b, d, c) != turn || shifted_side(d, a, c) != turn) return false;
  return orient3d(a, b, d, c) == turn;
}

// Parity of the number of other components round the one with lowest vertex v: that of the
// crossings of a ray from v to infinity, which never meets the own component.
bool is_inside_odd(Points points, Triangles triangles, const MeshTopology& topology,
                   const BoxTree& tree, Index own, Index v) {
  const auto start = tree.map(points[v]);
  Box ray;
  ray.add(start);
  ray.lo[0] = -Box::infinity;
  bool odd = false;
  tree.for_each_overlap(ray, 0, [&](std::size_t i) {
    const Index t = tree.triangle(i);
    if (topology.component[t] == own) return;
    const Triangle& corner = triangles[t];
    odd ^= ray_crosses(points[corner[0]], points[corner[1]], points[corner[2]], points[v]);
  });
  return odd;
}

}  // namespace

Defects find_inward_components(Points points, Triangles triangles, const MeshTopology& topology,
                               const BoxTree& tree, Job& job) {
  const std::vector<Lowest> lowest = find_lowest(points, triangles, topology);
  enum class State : std::uint8_t { right, wrong_outer, wrong_cavity };
  std::vector<State> state(lowest.size());
  constexpr std::size_t components_per_chunk = 16;
  parallel_chunks(
      lowest.size(), components_per_chunk, job.threads(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end && !job.cancelled(); ++c) {
          const Index v = lowest[c].vertex;
          const bool cavity =
              is_inside_odd(points, triangles, topology, tree, static_cast<Index>(c), v);
          const int wanted = cavity ? -1 : 1;
          if (facing(points, triangles, topology.star_of(v), v) != wanted)
            state[c] = cavity ? State::wrong_cavity : State::wrong_outer;
        }
      });
  job.tick(1);
  Defects inward;
  for (std::size_t c = 0; c < lowest.size(); ++c)
    if (state[c] != State::right)
      inward.add(lowest[c].triangle, state[c] == State::wrong_cavity ? 1 : 0);
  return inward;
}

}  // namespace arris
