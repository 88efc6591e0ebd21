// Evidence for inside and outside from positions alone: pairs of tetrahedra that should be on the
// same side, or on opposite sides, of the surface.
//
// Amenta, Choi, Kolluri, "The power crust" (2001): polar balls of one side intersect deeply, those
// of opposite sides at most slightly. Kolluri, Shewchuk, O'Brien, "Spectral surface reconstruction
// from noisy point clouds" (2004): the signed graph of such pairs.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "tetra/geometry.h"
#include "tetra/stars.h"
#include "tetra/tet_mesh.h"

namespace arris {

// How strongly one vote speaks, and what it says. Strength 0: no vote.
struct Vote {
  std::uint8_t strength = 0;
  bool opposite = false;
};

// All votes in flat arrays. The infinite tetrahedra count as one: the outside.
//
// A facet of a tetrahedron votes by the angle at which the circumballs on its two sides intersect,
// cos = (R1^2 + R2^2 - |c1 - c2|^2) / (2 R1 R2): +1 same ball, -1 touching from outside.
// A sample votes that its two poles (the farthest circumcentre of its star, and the farthest in the
// opposite half space) are opposite, by the angle between them.
struct Votes {
  std::vector<std::uint8_t> facet;            // [4 t + i], t < neighbour; see pack
  std::vector<std::uint8_t> pole;             // per sample
  std::vector<std::array<Tet, 2>> pole_pair;  // per sample; no_tet for the outside

  static std::uint8_t pack(Vote vote) noexcept {
    return static_cast<std::uint8_t>(vote.strength << 1 | (vote.opposite ? 1 : 0));
  }
  static Vote unpack(std::uint8_t packed) noexcept {
    return {static_cast<std::uint8_t>(packed >> 1), (packed & 1) != 0};
  }
  static constexpr int levels = 128;  // strengths are 0 .. levels - 1
};

// Which tetrahedra take part: circumradius above `big` times the mean spacing of their vertices.
// Complexity: O(tetrahedra), parallel.
Votes collect_votes(const TetMesh& mesh, const Stars& stars, const std::vector<Circumball>& balls,
                    const std::vector<double>& spacing, Job& job);

}  // namespace arris
