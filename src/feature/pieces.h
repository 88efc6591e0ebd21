// The smooth pieces that the points of a rough surface are on, told by its filtered normals.
#pragma once

#include <vector>

#include "base/vec.h"
#include "feature/facets.h"
#include "feature/small_set.h"

namespace arris {

// exp(-x²/2) of the length x of `difference` in units of `width`.
double falloff(Vec3 difference, double width);

// What is known of the piece a point is on.
struct Piece {
  Vec3 normal;       // unit, outward, there; zero if none
  double width = 0;  // of unlikeness: normals of one piece that differ by this chord are usual
};

// Per point the piece that takes most of its star, by normal_filter.h. O(facets) for bounded
// degrees, in parallel; the same for any number of threads.
std::vector<Piece> find_pieces(const std::vector<Vec3>& points, const FacetMesh& mesh,
                               unsigned threads);

// Walks over the mesh from a point as far as its piece goes. One for each thread.
class PieceWalk {
 public:
  // Holds on to both.
  PieceWalk(const FacetMesh& mesh, const std::vector<Piece>& pieces)
      : mesh_(mesh), pieces_(pieces) {}

  // The points of the piece of v within `far` of it, v first. O(found) for bounded degrees.
  const std::vector<Index>& from(Index v, const std::vector<Vec3>& points, double far);

 private:
  bool is_alike(Index v, Index w) const;

  const FacetMesh& mesh_;
  const std::vector<Piece>& pieces_;
  SmallSet seen_;
  std::vector<Index> found_;
  std::vector<Index> from_, buffer_;  // the facet over which each was found
};

}  // namespace arris
