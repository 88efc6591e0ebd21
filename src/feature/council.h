// Settles which of the surfaces that were sensed round a point pass through it.
#pragma once

#include <vector>

#include "feature/facets.h"
#include "feature/local_surface.h"

namespace arris {

// Two surfaces at one point are two sides of a feature if their normals differ by more than this.
inline constexpr double least_crease_degrees = 20;
// A point lies on a surface to this share of the spacing, small enough that an edge through it is
// as good as one beside it, and to twice the roughness.
inline constexpr double on_surface = 0.005;
inline double on_surface_distance(double spacing, double roughness) {
  return on_surface * spacing + 2 * roughness;
}

// Whether s is on the side that has this normal at p.
bool is_same_side(const LocalSurface& s, Vec3 normal, Vec3 p);

// Appends s to the sides at p unless one of them has nearly its direction there.
void add_distinct(const LocalSurface& s, Vec3 p, std::vector<LocalSurface>& sides);

// A patch may have been grown from a bad start, or across a feature. A surface counts if at least
// `least_support` points within two rings have found it too; those found by most come first. First
// among those that agree tightly, as samples on a plane do; failing that, the point's own, loosely.
class Council {
 public:
  // Holds on to all four. `found`: per point what was grown there.
  Council(const std::vector<Vec3>& points, const FacetMesh& mesh,
          const std::vector<double>& spacing, const std::vector<std::vector<LocalSurface>>& found,
          double roughness)
      : points_(points), mesh_(mesh), spacing_(spacing), found_(found), roughness_(roughness) {}

  // Appends the surfaces at v. O(n²) for the n points heard, a few hundred at most.
  void settle(Index v, std::vector<LocalSurface>& out);

 private:
  struct Proposal {
    const LocalSurface* surface;
    int support;
  };
  struct Agreement {
    double distance, angle;  // distance in units of spacing, radians
  };
  // A surface that was found at a point near v, and its normal at v.
  struct Voice {
    Index point;
    const LocalSurface* surface;
    Vec3 normal;
  };
  static const Agreement tight, loose;
  void listen(Index v, double far);
  void propose(Index v, const Agreement& agreement, bool own_only);
  const LocalSurface* agreed_by_all() const;
  int support(const LocalSurface& s, Vec3 normal, double far, double cosine) const;

  const std::vector<Vec3>& points_;
  const FacetMesh& mesh_;
  const std::vector<double>& spacing_;
  const std::vector<std::vector<LocalSurface>>& found_;
  double roughness_;
  SmallSet seen_;
  std::vector<Index> near_;
  std::vector<Voice> voices_;  // in the order of near_
  std::vector<Proposal> proposals_;
};

}  // namespace arris
