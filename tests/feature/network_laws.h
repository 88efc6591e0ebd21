// What holds of every network of feature curves, whatever the mesh.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "arris/features.h"

namespace arris::test {

using Edge = std::pair<Index, Index>;

inline Edge edge(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

// The edges of a curve in order.
inline std::vector<Edge> edges_of(const FeatureCurve& curve) {
  std::vector<Edge> edges;
  for (std::size_t k = 0; k + 1 < curve.vertices.size(); ++k)
    edges.push_back(edge(curve.vertices[k], curve.vertices[k + 1]));
  if (curve.closed) edges.push_back(edge(curve.vertices.back(), curve.vertices.front()));
  return edges;
}

inline std::map<Edge, std::vector<Index>> faces_of_edges(const Mesh& mesh) {
  std::map<Edge, std::vector<Index>> faces;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      faces[edge(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3])].push_back(
          static_cast<Index>(t));
  return faces;
}

// Curves are chains of mesh edges, each on one curve once; they end at corners and nowhere else.
inline void expect_sound_curves(const Mesh& mesh, const FeatureNetwork& network) {
  const auto faces = faces_of_edges(mesh);
  std::set<Edge> seen;
  std::map<Index, std::uint32_t> ends, passes;
  for (const FeatureCurve& curve : network.curves) {
    ASSERT_GE(curve.vertices.size(), curve.closed ? 3u : 2u);
    for (const Edge& e : edges_of(curve)) {
      EXPECT_TRUE(faces.contains(e)) << e.first << " " << e.second;
      EXPECT_TRUE(seen.insert(e).second) << "twice: " << e.first << " " << e.second;
    }
    for (std::size_t k = 0; k < curve.vertices.size(); ++k) {
      const bool end = !curve.closed && (k == 0 || k + 1 == curve.vertices.size());
      ++(end ? ends : passes)[curve.vertices[k]];
    }
  }
  std::map<Index, std::uint32_t> degrees;
  for (const FeatureCorner& corner : network.corners) {
    EXPECT_TRUE(degrees.emplace(corner.vertex, corner.degree).second);
    EXPECT_EQ(corner.position, mesh.vertices[corner.vertex]);
  }
  EXPECT_EQ(degrees, ends);
  for (const auto& [v, times] : passes) {
    EXPECT_EQ(times, 1u) << v;
    EXPECT_FALSE(ends.contains(v)) << v;
  }
}

// Taking the edges of the curves out of the mesh leaves exactly the patches.
inline void expect_sound_patches(const Mesh& mesh, const FeatureNetwork& network) {
  ASSERT_EQ(network.patch.size(), mesh.triangles.size());
  std::set<Edge> cut;
  for (const FeatureCurve& curve : network.curves)
    for (const Edge& e : edges_of(curve)) cut.insert(e);
  std::vector<Index> root(mesh.triangles.size());
  for (std::size_t t = 0; t < root.size(); ++t) root[t] = static_cast<Index>(t);
  const auto find = [&](Index t) {
    while (root[t] != t) t = root[t] = root[root[t]];
    return t;
  };
  for (const auto& [e, faces] : faces_of_edges(mesh))
    if (!cut.contains(e))
      for (Index f : faces) root[find(f)] = find(faces[0]);
  std::map<Index, Index> patch_of_root;
  std::set<Index> patches;
  for (std::size_t t = 0; t < root.size(); ++t) {
    const auto [place, fresh] =
        patch_of_root.emplace(find(static_cast<Index>(t)), network.patch[t]);
    EXPECT_EQ(place->second, network.patch[t]);
    if (fresh) {
      EXPECT_EQ(network.patch[t], patches.size());  // by lowest triangle
      patches.insert(network.patch[t]);
    }
  }
  EXPECT_EQ(patches.size(), network.patches);
  EXPECT_EQ(patch_of_root.size(), network.patches);
}

}  // namespace arris::test
