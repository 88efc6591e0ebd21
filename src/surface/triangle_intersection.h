// Whether two triangles of a mesh meet outside the corners they share; exact.
#pragma once

#include <array>
#include <span>

#include "arris/types.h"

namespace arris {

// A non-degenerate triangle, made ready for tests against others.
struct Facet {
  std::array<Index, 3> index;
  std::array<Vec3, 3> corner;
  // Projected along this axis (as in orient2d) the triangle is not degenerate; the orientation it
  // then has, +1 or -1.
  int axis = 0;
  int turn = 0;
  // The normal in rounded arithmetic, and what bounds its error: the sums of the magnitudes of the
  // products it is made of.
  Vec3 normal;
  Vec3 permanent;
};

// The corners must be distinct and not collinear.
Facet make_facet(std::span<const Vec3> points, const Triangle& triangle);

// The intersection of the two closed triangles is more than their shared vertices (shared by index)
// or, if they share two, their common edge. Triangles that share nothing meet if they touch in a
// single point; triangles with the same three corners always meet.
bool facets_meet(const Facet& a, const Facet& b);

}  // namespace arris
