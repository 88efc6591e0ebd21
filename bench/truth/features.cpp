// Points on the corners and along the sharp edges of a mesh.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "base/vec.h"
#include "truth/feature_graph.h"
#include "truth/measure.h"
#include "truth/samplers.h"

namespace arris::truth {
namespace {

constexpr double pi = std::numbers::pi;

// A polyline of sharp edges from corner to corner, or a loop.
struct Chain {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;  // of its segments
};

// From vertex `start` along sharp edge `e` to the next corner, or round to `start` again.
Chain walk_chain(const Mesh& mesh, const FeatureGraph& g, Index start, std::size_t e,
                 std::vector<bool>& walked) {
  Chain chain{{mesh.vertices[start]}, {}};
  for (Index v = start;;) {
    walked[e] = true;
    v = g.other_end(e, v);
    chain.points.push_back(mesh.vertices[v]);
    chain.normals.push_back(g.sharp[e].normal);
    if (g.corner[v] || v == start) return chain;
    e = g.at[v][g.at[v][0] == e ? 1 : 0];
  }
}

// More parts than memory has room for come of needles, whose edges are long for their area.
constexpr double most_parts = 1e8;

// The inner points that divide the chain into equal parts no longer than `spacing`.
void divide(const Chain& chain, double spacing, Samples& samples) {
  const std::vector<Vec3>& p = chain.points;
  double total = 0;
  for (std::size_t i = 1; i < p.size(); ++i) total += distance(p[i - 1], p[i]);
  if (!(total / spacing < most_parts))
    throw std::invalid_argument("the sharp edges are too long for the area of the mesh");
  const auto parts = static_cast<std::size_t>(std::ceil(total / spacing));
  const double step = total / static_cast<double>(parts);
  double before = 0;  // length up to point i - 1
  for (std::size_t i = 1, k = 1; i < p.size(); ++i) {
    const double here = distance(p[i - 1], p[i]);
    for (; k < parts && static_cast<double>(k) * step < before + here; ++k) {
      const double s = std::max(0.0, (static_cast<double>(k) * step - before) / here);
      samples.add(p[i - 1] + s * (p[i] - p[i - 1]), chain.normals[i - 1]);
    }
    before += here;
  }
}

// Per vertex the sum of its normals, weighted by the angles of its triangles, and of those angles.
struct VertexAngles {
  std::vector<Vec3> normal;
  std::vector<double> sum;
};

VertexAngles vertex_angles(const Mesh& mesh) {
  VertexAngles result{std::vector<Vec3>(mesh.vertices.size()),
                      std::vector<double>(mesh.vertices.size(), 0)};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 n = normal(mesh, static_cast<Index>(t));
    if (length(n) == 0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index v = mesh.triangles[t][i];
      const Vec3 u = mesh.vertices[mesh.triangles[t][(i + 1) % 3]] - mesh.vertices[v];
      const Vec3 w = mesh.vertices[mesh.triangles[t][(i + 2) % 3]] - mesh.vertices[v];
      const double angle = std::atan2(length(cross(u, w)), dot(u, w));
      result.sum[v] += angle;
      result.normal[v] = result.normal[v] + (angle / length(n)) * n;
    }
  }
  return result;
}

void add_corners(const Mesh& mesh, const FeatureGraph& g, Samples& samples) {
  constexpr double tip = 1.5 * pi;  // angles of a cone of 97 degrees; a smooth vertex has 2 pi
  const VertexAngles angles = vertex_angles(mesh);
  for (Index v = 0; v < g.corner.size(); ++v) {
    const bool is_tip = g.at[v].empty() && angles.sum[v] > 0 && angles.sum[v] < tip;
    if (!g.corner[v] && !is_tip) continue;
    const double l = length(angles.normal[v]);
    samples.add(mesh.vertices[v],
                l > 0 ? (1 / l) * angles.normal[v] : g.sharp[g.at[v].front()].normal);
  }
}

}  // namespace

Samples feature_samples(const Mesh& mesh, double spacing, double edge_angle) {
  const FeatureGraph g = feature_graph(mesh, edge_angle * pi / 180);
  Samples samples;
  add_corners(mesh, g, samples);
  std::vector<bool> walked(g.sharp.size());
  for (Index v = 0; v < g.corner.size(); ++v)
    if (g.corner[v])
      for (const std::size_t e : g.at[v])
        if (!walked[e]) divide(walk_chain(mesh, g, v, e, walked), spacing, samples);
  // What is left are loops without a corner.
  for (std::size_t e = 0; e < g.sharp.size(); ++e) {
    if (walked[e]) continue;
    samples.add(mesh.vertices[g.sharp[e].a], g.sharp[e].normal);
    divide(walk_chain(mesh, g, g.sharp[e].a, e, walked), spacing, samples);
  }
  return samples;
}

std::vector<Vec3> feature_points(const Mesh& mesh, double spacing, double edge_angle) {
  return feature_samples(mesh, spacing, edge_angle).positions;
}

}  // namespace arris::truth
