// Faces too small for a patch: planes on which more samples lie than chance would put there, where
// no surface explains them. The test is a contrario, after Desolneux, Moisan, Morel, "Meaningful
// alignments" (2000).
#pragma once

#include <utility>
#include <vector>

#include "feature/facets.h"
#include "feature/local_surface.h"

namespace arris {

// For clean samples: noise hides what it looks for. One for each thread: it keeps its scratch.
class SmallPlanes {
 public:
  // Holds on to all four. `open`: 1 for the points that no surface explains.
  SmallPlanes(const std::vector<Vec3>& points, const FacetMesh& mesh,
              const std::vector<double>& spacing, const std::vector<std::uint8_t>& open)
      : points_(points), mesh_(mesh), spacing_(spacing), open_(open) {}

  // Appends the least likely plane through v and at least three of the open points within two
  // rings, if it is unlikely enough. O(1): few points are looked at.
  void find(Index v, std::vector<LocalSurface>& out);

 private:
  struct Plane {
    Vec3 normal;
    double false_alarms;  // as many planes as good would be there by chance
    std::vector<Index> members;
  };
  void gather(Index v);
  void try_plane(Index v, std::size_t i, std::size_t j, Plane& best);
  Vec3 outward(Index v) const;

  const std::vector<Vec3>& points_;
  const FacetMesh& mesh_;
  const std::vector<double>& spacing_;
  const std::vector<std::uint8_t>& open_;
  SmallSet seen_;
  std::vector<Index> near_;
  std::vector<std::pair<double, Index>> off_;  // distance from a plane over h, point
};

}  // namespace arris
