// Sharp edges and corners of surfaces, and how well those of two surfaces match.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "compare/compare.h"
#include "compare/surface.h"

namespace arris::compare {

// An edge and the angle by which the surface turns at it, in degrees.
struct EdgeTurn {
  Index a = no_index, b = no_index;
  double turn = 0;  // 0 to 180; infinite with more than two triangles
};

// All edges of a surface at which it turns, and what corners need to know beside them.
struct EdgeTurns {
  std::vector<EdgeTurn> edges;
  std::uint64_t odd_edges = 0;          // with an odd number of triangles
  std::uint64_t unbalanced_edges = 0;   // even, but not half of them walk it either way
  std::vector<double> defect;           // per vertex: 2 pi less the angles round it, radians
  std::vector<std::uint8_t> uncertain;  // per vertex: at a boundary or a degenerate triangle
};

// Complexity: O(n log n).
EdgeTurns measure_edges(const Surface& surface);

// The sharp edges and corners at one threshold.
struct Features {
  std::vector<Triangle> edges;       // {a, b, b}
  std::vector<double> length_until;  // up to the end of each edge
  std::vector<Triangle> corners;     // {v, v, v}
  double length() const { return length_until.empty() ? 0 : length_until.back(); }
};

Features find_features(const Surface& surface, const EdgeTurns& turns, double dihedral);

// Throws Failure(cancelled).
FeatureScore match_features(const Surface& result, const Features& of_result, const Surface& truth,
                            const Features& of_truth, double dihedral, Job& job);

}  // namespace arris::compare
