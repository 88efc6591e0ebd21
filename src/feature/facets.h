// A closed triangle surface over a point array, with the neighbourhoods that sensing walks along.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "arris/types.h"
#include "feature/small_set.h"
#include "tetra/facet_stars.h"

namespace arris {

// Of a point with more facets than this only those nearest to where one comes from are looked at:
// the tip of a cone has as many as its rim has points, and each of these would look at all.
// Ordinary samples have six, those at large holes a few dozen.
inline constexpr std::size_t most_round = 64;

// Flat arrays: facets, the facet across each side, the facets round each point.
struct FacetMesh {
  std::vector<Triangle> facets;                  // indices of points, outward
  std::vector<std::array<Index, 3>> neighbours;  // [f][i]: across the side opposite corner i
  std::vector<Vec3> normal;                      // unit; zero where a facet has none to judge by
  FacetStars stars;

  // Every side must be shared by exactly two facets, in opposite directions; throws
  // Failure(internal) otherwise. O(points + facets) for bounded genus, whatever the degrees.
  FacetMesh(std::vector<Triangle> triangles, const std::vector<Vec3>& points, unsigned threads);

  std::span<const Index> star(Index v) const noexcept { return stars[v]; }

  // The star of v, or of more than most_round facets as many on both sides of `facet`, which is one
  // of them, going round v. Ascending; uses `buffer`. O(most_round).
  std::span<const Index> star_near(Index v, Index facet, std::vector<Index>& buffer) const;
};

// The angle of a facet at its corner v, in radians.
double angle_at(const std::vector<Vec3>& points, const Triangle& facet, Index v);

// The points that share a facet with v, ascending. O(degree).
void ring(const FacetMesh& mesh, Index v, std::vector<Index>& out);
// Those of the rings of the ring, too, without v; of points of more than most_round facets those
// near v alone. `seen` is scratch. O(n log n) for n = degree * most_round at most.
void two_rings(const FacetMesh& mesh, Index v, SmallSet& seen, std::vector<Index>& out);

// Keeps of a list of points the `most` nearest to v, ascending; a list that is no longer stays as
// it is. O(n).
void keep_nearest(const std::vector<Vec3>& points, Index v, std::size_t most,
                  std::vector<Index>& list);

// Marks the points at sides where the surface bends by more than `angle` (radians). O(facets).
std::vector<std::uint8_t> at_bends(const FacetMesh& mesh, double angle, std::size_t points);

// Marks the points within `rings` rings of marked ones, too. O(rings * facets).
void spread(const std::vector<Triangle>& facets, int rings, std::vector<std::uint8_t>& marked);

}  // namespace arris
