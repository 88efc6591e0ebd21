#include "truth/feature_graph.h"

#include <cmath>

#include "base/vec.h"
#include "truth/measure.h"

namespace arris::truth {
namespace {

Vec3 unit(Vec3 v) {
  const double l = length(v);
  return l > 0 ? (1 / l) * v : v;
}

// The angle by which the surface turns from one side of an edge to the other, in [0, pi].
double turn_between(const Mesh& mesh, const HalfEdge& l, const HalfEdge& r) {
  const Vec3 m = normal(mesh, l.triangle), n = normal(mesh, r.triangle);
  const double same = l.forward != r.forward ? 1 : -1;  // triangles may be walked inconsistently
  return std::atan2(length(cross(m, n)), same * dot(m, n));
}

// Two sharp edges that pass straight through are no corner.
bool is_corner(const Mesh& mesh, const FeatureGraph& g, Index v, double angle) {
  if (g.at[v].size() != 2) return !g.at[v].empty();
  const Vec3 in = mesh.vertices[v] - mesh.vertices[g.other_end(g.at[v][0], v)];
  const Vec3 out = mesh.vertices[g.other_end(g.at[v][1], v)] - mesh.vertices[v];
  return std::atan2(length(cross(in, out)), dot(in, out)) > angle;
}

}  // namespace

FeatureGraph feature_graph(const Mesh& mesh, double angle) {
  FeatureGraph g;
  g.at.resize(mesh.vertices.size());
  const std::vector<HalfEdge> sides = sorted_half_edges(mesh);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    const Index a = sides[i].a, b = sides[i].b;
    Vec3 sum;
    for (end = i; end < sides.size() && sides[end].a == a && sides[end].b == b; ++end)
      sum = sum + unit(normal(mesh, sides[end].triangle));
    if (end - i == 2 && turn_between(mesh, sides[i], sides[i + 1]) <= angle) continue;
    // On a knife's edge the normals cancel; either will do.
    const Vec3 mean = length(sum) > 1e-9 ? sum : normal(mesh, sides[i].triangle);
    g.at[a].push_back(g.sharp.size());
    g.at[b].push_back(g.sharp.size());
    g.sharp.push_back({a, b, unit(mean)});
  }
  g.corner.resize(mesh.vertices.size());
  for (Index v = 0; v < g.at.size(); ++v) g.corner[v] = is_corner(mesh, g, v, angle);
  return g;
}

}  // namespace arris::truth
