// Seeds of the cut: which tetrahedra are inside and outside, from positions alone (the paper is
// silent here; design: docs/method.md).
#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "tetra/geometry.h"
#include "tetra/stars.h"
#include "tetra/tet_mesh.h"

namespace arris {

// What is known of a tetrahedron before the cut.
using Seed = std::uint8_t;
inline constexpr Seed seed_outside = 0;
inline constexpr Seed seed_inside = 1;
inline constexpr Seed seed_free = 2;

// Balls larger than this many spacings reach well away from the sampling noise of the surface, so
// their label is firm; the cut may overrule that of smaller ones. Three spacings, the thinnest wall
// to be kept, have balls of 1.5.
inline constexpr double firm_radius = 1.5;

struct Seeds {
  std::vector<Seed> label;         // per finite tetrahedron; seed_free where no vote reached
  std::vector<std::uint8_t> firm;  // 1: the cut must keep the label; 0: it may overrule it
  std::vector<std::uint8_t> hint;  // 1: the label only breaks ties; empty: none is a hint
  double contradiction = 0;        // share of vote strength refused, in [0, 1]
  std::vector<float> confidence;   // per sample: share of vote strength round it that agrees
};

// Takes the votes strongest first into a union-find with parity (a maximum spanning forest of the
// signed graph) and refuses those that contradict stronger ones. What is joined to the outside gets
// its label. One pass, O(n log n) for the spatial order, near-linear otherwise. Deterministic.
Seeds find_seeds(const TetMesh& mesh, const Stars& stars, const std::vector<Circumball>& balls,
                 const std::vector<double>& spacing, Job& job);

}  // namespace arris
