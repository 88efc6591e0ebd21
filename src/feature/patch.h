// Grows one smooth patch of facets round a point and fits a plane or a quadric to its points: what
// the surface does on one side of a feature. One-sided neighbourhoods after Öztireli, Guennebaud,
// Gross, "Feature Preserving Point Set Surfaces based on Non-Linear Kernel Regression" (2009);
// osculating quadrics after Cazals, Pouget, "Estimating differential quantities using polynomial
// fitting of osculating jets" (2003).
#pragma once

#include <vector>

#include "feature/facets.h"
#include "feature/local_surface.h"

namespace arris {

struct Patch {
  std::vector<Index> members;  // points, the centre first
  std::vector<double> weight;  // per member: falls off with the distance from the centre
  std::vector<Index> facets;
  LocalSurface surface;
};

// How far a facet may lean from the fit so far, and a point lie off it.
struct PatchTolerance {
  explicit PatchTolerance(double radians);
  double tangent, cosine, cosine_twice;
};

// Takes facets nearest first while they agree with the fit so far: a plane at first, a quadric from
// `quadric_members` points on. At last the fit is made robust: points that the others do not bear
// out lose their say, and it stays a plane if most lie on one. O(1): patches are bounded.
class PatchGrower {
 public:
  // Holds on to all three.
  PatchGrower(const std::vector<Vec3>& points, const FacetMesh& mesh,
              const std::vector<double>& spacing)
      : points_(points), mesh_(mesh), spacing_(spacing) {}

  // The patch round `centre` that starts with facet `seed` of its star.
  Patch grow(Index centre, Index seed, const PatchTolerance& tolerance) const;

  // Members enough, on a wide enough sector round the centre, to be more than a bevel.
  bool is_large(const Patch& patch) const;

 private:
  bool accepts(const Patch& patch, Index facet, const PatchTolerance& tolerance) const;
  bool add_facet(Patch& patch, Index facet) const;
  Vec3 middle(Index facet) const;

  const std::vector<Vec3>& points_;
  const FacetMesh& mesh_;
  const std::vector<double>& spacing_;
};

}  // namespace arris
