// Sharp edges of a mesh as chains between corners, and points along them.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "base/vec.h"
#include "support/measure.h"
#include "support/samplers.h"

namespace arris::test {
namespace {

// The sharp edges, and for every vertex those that end in it.
struct FeatureGraph {
  std::vector<Edge> sharp;
  std::vector<std::vector<std::size_t>> at;
  std::vector<bool> corner;  // an end of chains: not passed straight through by two sharp edges

  Index other_end(std::size_t e, Index v) const {
    return sharp[e].a == v ? sharp[e].b : sharp[e].a;
  }
};

FeatureGraph feature_graph(const Mesh& mesh, double angle) {
  FeatureGraph g;
  g.at.resize(mesh.vertices.size());
  for (const Edge& e : edges(mesh)) {
    if (std::abs(turn(mesh, e)) <= angle) continue;
    g.at[e.a].push_back(g.sharp.size());
    g.at[e.b].push_back(g.sharp.size());
    g.sharp.push_back(e);
  }
  g.corner.resize(mesh.vertices.size());
  for (Index v = 0; v < g.at.size(); ++v) {
    if (g.at[v].empty()) continue;
    if (g.at[v].size() != 2) {
      g.corner[v] = true;
      continue;
    }
    const Vec3 in = mesh.vertices[v] - mesh.vertices[g.other_end(g.at[v][0], v)];
    const Vec3 out = mesh.vertices[g.other_end(g.at[v][1], v)] - mesh.vertices[v];
    g.corner[v] = std::atan2(length(cross(in, out)), dot(in, out)) > angle;
  }
  return g;
}

// The vertices from `start` along sharp edge `e` to the next corner, or round to `start` again.
std::vector<Vec3> walk_chain(const Mesh& mesh, const FeatureGraph& g, Index start, std::size_t e,
                             std::vector<bool>& walked) {
  std::vector<Vec3> chain = {mesh.vertices[start]};
  for (Index v = start;;) {
    walked[e] = true;
    v = g.other_end(e, v);
    chain.push_back(mesh.vertices[v]);
    if (g.corner[v] || v == start) return chain;
    e = g.at[v][g.at[v][0] == e ? 1 : 0];
  }
}

// The inner points that divide the chain into equal parts no longer than `spacing`.
void divide(const std::vector<Vec3>& chain, double spacing, std::vector<Vec3>& points) {
  double total = 0;
  for (std::size_t i = 1; i < chain.size(); ++i) total += distance(chain[i - 1], chain[i]);
  const auto parts = static_cast<std::size_t>(std::ceil(total / spacing));
  const double step = total / static_cast<double>(parts);
  double before = 0;  // length up to chain[i - 1]
  for (std::size_t i = 1, k = 1; i < chain.size(); ++i) {
    const double here = distance(chain[i - 1], chain[i]);
    for (; k < parts && static_cast<double>(k) * step < before + here; ++k) {
      const double s = std::max(0.0, (static_cast<double>(k) * step - before) / here);
      points.push_back(chain[i - 1] + s * (chain[i] - chain[i - 1]));
    }
    before += here;
  }
}

}  // namespace

std::vector<Vec3> feature_points(const Mesh& mesh, double spacing, double edge_angle) {
  const FeatureGraph g = feature_graph(mesh, edge_angle * std::numbers::pi / 180);
  std::vector<Vec3> points;
  for (Index v = 0; v < g.corner.size(); ++v)
    if (g.corner[v]) points.push_back(mesh.vertices[v]);

  std::vector<bool> walked(g.sharp.size());
  for (Index v = 0; v < g.corner.size(); ++v)
    if (g.corner[v])
      for (const std::size_t e : g.at[v])
        if (!walked[e]) divide(walk_chain(mesh, g, v, e, walked), spacing, points);
  // What is left are loops without a corner.
  for (std::size_t e = 0; e < g.sharp.size(); ++e) {
    if (walked[e]) continue;
    points.push_back(mesh.vertices[g.sharp[e].a]);
    divide(walk_chain(mesh, g, g.sharp[e].a, e, walked), spacing, points);
  }
  return points;
}

}  // namespace arris::test
