#include "feature/patches.h"

namespace arris {

void label_patches(const Network& network, FeatureNetwork& result) {
  const MeshEdges& edges = network.edges();
  result.patch.assign(edges.of_face.size(), no_index);
  std::vector<Index> stack;
  for (std::size_t seed = 0; seed < result.patch.size(); ++seed) {
    if (result.patch[seed] != no_index) continue;
    const auto label = static_cast<Index>(result.patches++);
    result.patch[seed] = label;
    stack.push_back(static_cast<Index>(seed));
    while (!stack.empty()) {
      const Index t = stack.back();
      stack.pop_back();
      for (Index e : edges.of_face[t]) {
        if (e == no_index || network.has(e)) continue;
        for (Index n : edges.edges[e].faces) {
          if (n == no_index || result.patch[n] != no_index) continue;
          result.patch[n] = label;
          stack.push_back(n);
        }
      }
    }
  }
}

}  // namespace arris
