// Where the surface runs across a feature that no sample marks: sides whose ends lie on different
// sensed surfaces.
#pragma once

#include <cstdint>
#include <vector>

#include "feature/sense.h"

namespace arris {

// A surface and the point it was sensed at.
struct Side {
  Index point;
  const LocalSurface* surface;
  Index facet = no_index;  // one at the point: where one looks round it from, if one does
};

// +1: the material's edge is convex, -1: concave, 0: the surfaces do not bound an edge there.
enum class Turn : std::int8_t { concave = -1, none = 0, convex = 1 };

// What is asked about pairs of points again and again. Holds on to all four.
struct Crossing {
  const std::vector<Vec3>& points;
  const FacetMesh& mesh;
  const std::vector<double>& spacing;
  const Sensed& sensed;

  // Each passes through the point of the other, in nearly the same direction.
  bool agree(const Side& a, const Side& b) const;
  // Both points have surfaces, and none of one agrees with one of the other.
  bool crosses(Index u, Index v) const;
  Turn turn(const Side& a, const Side& b) const;
};

// A side whose ends cross, and one of its facets.
struct CrossingSide {
  Index u, v;
  Index facet;
};

// Those of the mesh, lower end first, each once. O(facets).
std::vector<CrossingSide> crossing_sides(const Crossing& crossing);

}  // namespace arris
