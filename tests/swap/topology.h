// The boundary of labels counted from scratch, without the machinery under test.
#pragma once

#include <map>
#include <set>
#include <utility>

#include "tetra/tet_mesh.h"

namespace arris::test {

struct Topology {
  bool manifold = true;
  long euler = 0;
  std::set<Index> vertices;
};

inline Topology topology(const TetMesh& mesh, const Labels& labels) {
  Topology result;
  std::map<std::pair<Index, Index>, int> edges;
  std::map<Index, std::map<Index, std::vector<Index>>> links;  // vertex -> graph of its link
  long facets = 0;
  for (Tet t = 0; t < mesh.finite; ++t)
    for (std::size_t i = 0; i < 4; ++i) {
      if (labels[t] == 0 || labels[mesh.neighbours[t][i]] != 0) continue;
      ++facets;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at = [&](std::size_t c) {
          return mesh.vertices[t][static_cast<std::size_t>(facet_corners[i][c % 3])];
        };
        ++edges[std::minmax(at(k), at(k + 1))];
        links[at(k)][at(k + 1)].push_back(at(k + 2));
        links[at(k)][at(k + 2)].push_back(at(k + 1));
        result.vertices.insert(at(k));
      }
    }
  for (const auto& [edge, count] : edges) result.manifold &= count == 2;
  for (const auto& [v, link] : links) {  // one cycle: connected, every degree 2
    std::set<Index> seen = {link.begin()->first};
    std::vector<Index> stack(seen.begin(), seen.end());
    while (!stack.empty()) {
      const Index u = stack.back();
      stack.pop_back();
      for (Index w : link.at(u))
        if (seen.insert(w).second) stack.push_back(w);
    }
    result.manifold &= seen.size() == link.size();
  }
  result.euler =
      static_cast<long>(result.vertices.size()) - static_cast<long>(edges.size()) + facets;
  return result;
}

}  // namespace arris::test
