// Settles which of the surfaces that were sensed round a point pass through it.
#pragma once

#include <vector>

#include "feature/facets.h"
#include "feature/local_surface.h"

namespace arris {

// Two surfaces at one point are two sides of a feature if their normals differ by more than this.
inline constexpr double least_crease_degrees = 20;
// A point lies on a surface to this share of the spacing: small enough that an edge through it is
// as good as one beside it.
inline constexpr double on_surface = 0.005;

// A patch may have been grown from a bad start, or across a feature. A surface counts if at least
// `least_support` points within two rings have found it too; those found by most come first. First
// among those that agree tightly, as samples on a plane do; failing that, the point's own, loosely.
class Council {
 public:
  // Holds on to all four. `found`: per point what was grown there.
  Council(const std::vector<Vec3>& points, const FacetMesh& mesh,
          const std::vector<double>& spacing, const std::vector<std::vector<LocalSurface>>& found)
      : points_(points), mesh_(mesh), spacing_(spacing), found_(found) {}

  // Appends the surfaces at v. O(degree^4), all small.
  void settle(Index v, std::vector<LocalSurface>& out);

 private:
  struct Proposal {
    const LocalSurface* surface;
    bool own;
    int support;
  };
  struct Agreement {
    double distance, cosine;  // distance in units of spacing
  };
  static const Agreement tight, loose;
  void propose(Index v, const Agreement& agreement, bool own_only);
  int support(const LocalSurface& s, Index v, const Agreement& agreement) const;

  const std::vector<Vec3>& points_;
  const FacetMesh& mesh_;
  const std::vector<double>& spacing_;
  const std::vector<std::vector<LocalSurface>>& found_;
  std::vector<Index> near_;
  std::vector<Proposal> proposals_;
};

}  // namespace arris
