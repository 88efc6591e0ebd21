#include "feature/small_patches.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/angle.h"
#include "feature/patches.h"

namespace arris {
namespace {

// A vertex has six triangles round it, on average.
constexpr std::size_t smallest_patch = 6;

// The facet of a polyhedron is flat up to rounding; a single triangle is one if its edges turn by
// what no well sampled surface does (creases.cpp: clear).
constexpr double flat = radians(0.1), sharp_all_round = radians(60);

// Next to a patch of this many triangles the mesh is no coarse polyhedron.
constexpr std::size_t fine_patch = 64;

// Each round dissolves a layer of a cluster.
constexpr int most_rounds = 16;

// A stretch of the network between a small patch and one of its neighbours.
struct Border {
  Index small, other;
  Index edge;
};

struct PatchFacts {
  std::size_t triangles = 0;
  double most_inside = 0;          // the largest turning at edges within
  double least_around = 10;        // the least at edges of its border
  std::size_t largest_beside = 0;  // triangles of the largest neighbour
};

std::vector<PatchFacts> examine(const Network& network, const FeatureNetwork& patches) {
  std::vector<PatchFacts> facts(patches.patches);
  const MeshEdges& edges = network.edges();
  for (Index p : patches.patch) ++facts[p].triangles;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const MeshEdge& edge = edges.edges[e];
    const double turning = std::abs(edge.turning);
    for (std::size_t k = 0; k < 2; ++k) {
      const Index f = edge.faces[k], g = edge.faces[1 - k];
      if (f == no_index) continue;
      PatchFacts& p = facts[patches.patch[f]];
      if (g != no_index && patches.patch[g] != patches.patch[f])
        p.largest_beside = std::max(p.largest_beside, facts[patches.patch[g]].triangles);
      if (network.has(static_cast<Index>(e)))
        p.least_around = std::min(p.least_around, turning);
      else
        p.most_inside = std::max(p.most_inside, turning);
    }
  }
  return facts;
}

bool is_small(const PatchFacts& p) {
  if (p.triangles >= smallest_patch) return false;
  if (p.largest_beside >= fine_patch) return true;
  return p.triangles == 1 ? p.least_around < sharp_all_round : p.most_inside > flat;
}

// All edges between small patches and others, those of one pair of patches together.
std::vector<Border> borders_of_small(const Network& network, const FeatureNetwork& patches,
                                     const std::vector<PatchFacts>& facts) {
  std::vector<Border> borders;
  const MeshEdges& edges = network.edges();
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto& faces = edges.edges[e].faces;
    if (!network.has(static_cast<Index>(e)) || faces[1] == no_index) continue;
    const Index a = patches.patch[faces[0]], b = patches.patch[faces[1]];
    if (a == b) continue;
    if (is_small(facts[a])) borders.push_back({a, b, static_cast<Index>(e)});
    if (is_small(facts[b])) borders.push_back({b, a, static_cast<Index>(e)});
  }
  std::sort(borders.begin(), borders.end(), [](const Border& a, const Border& b) {
    if (a.small != b.small) return a.small < b.small;
    return a.other != b.other ? a.other < b.other : a.edge < b.edge;
  });
  return borders;
}

// The mean turning of a stretch, by length.
double mean_turning(const MeshEdges& edges, const Border* begin, const Border* end) {
  double turned = 0, length = 0;
  for (const Border* b = begin; b < end; ++b) {
    turned += std::abs(edges.edges[b->edge].turning) * edges.edges[b->edge].length;
    length += edges.edges[b->edge].length;
  }
  return length > 0 ? turned / length : 0;
}

// Takes out the weakest stretch of the border of each small patch; false if there is none.
bool merge_once(Network& network) {
  FeatureNetwork patches;
  label_patches(network, patches);
  const std::vector<PatchFacts> facts = examine(network, patches);
  const std::vector<Border> borders = borders_of_small(network, patches, facts);
  const Border* const all_end = borders.data() + borders.size();
  for (const Border* begin = borders.data(); begin < all_end;) {
    const Index small = begin->small;
    const Border *weakest = nullptr, *weakest_end = nullptr;
    double least = 0;
    while (begin < all_end && begin->small == small) {
      const Border* end = begin;
      while (end < all_end && end->small == small && end->other == begin->other) ++end;
      const double turning = mean_turning(network.edges(), begin, end);
      if (!weakest || turning < least) {
        weakest = begin;
        weakest_end = end;
        least = turning;
      }
      begin = end;
    }
    for (const Border* b = weakest; b < weakest_end; ++b) network.remove(b->edge);
  }
  return !borders.empty();
}

}  // namespace

void merge_small_patches(Network& network) {
  for (int round = 0; round < most_rounds; ++round)
    if (!merge_once(network)) return;
}

}  // namespace arris
