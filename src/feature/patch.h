// Grows one smooth patch of facets round a point and fits a plane or a quadric to its points: what
// the surface does on one side of a feature. One-sided neighbourhoods after Öztireli, Guennebaud,
// Gross, "Feature Preserving Point Set Surfaces based on Non-Linear Kernel Regression" (2009);
// osculating quadrics after Cazals, Pouget, "Estimating differential quantities using polynomial
// fitting of osculating jets" (2003).
#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "feature/facets.h"
#include "feature/fit.h"
#include "feature/local_surface.h"
#include "feature/small_set.h"

namespace arris {

struct Patch {
  std::vector<Index> members;  // points, the centre first
  std::vector<Index> facets;
  LocalSurface surface;
};

// How far a facet may lean from the fit so far, and a point lie off it.
struct PatchTolerance {
  explicit PatchTolerance(double radians) : angle(radians), tangent(std::tan(radians)) {}
  double angle, tangent;
};

// Takes facets nearest first while they agree with the fit so far: a plane at first, a quadric from
// `quadric_members` points on. At last the fit is made robust: points that the others do not bear
// out lose their say, and it stays a plane if most lie on one. O(1): patches are bounded. One for
// each thread: it keeps its scratch.
class PatchGrower {
 public:
  // Holds on to all three. `roughness`: a length by which points lie off the surface, though clean.
  PatchGrower(const std::vector<Vec3>& points, const FacetMesh& mesh,
              const std::vector<double>& spacing, double roughness)
      : points_(points), mesh_(mesh), spacing_(spacing), roughness_(roughness) {}

  // The patch round `centre` that starts with facet `seed` of its star; none if it is no more than
  // a bevel: members enough, on a wide enough sector round the centre.
  std::optional<Patch> grow(Index centre, Index seed, const PatchTolerance& tolerance);

 private:
  // What a patch accepts, as a plane and as a quadric.
  struct Limits {
    double plane_cosine, quadric_cosine, tangent;
  };
  // What is known of a point that a patch came to.
  struct Reached {
    double far = -1;       // from the centre; negative: not yet measured
    int fit = -1;          // the number of the fit for which the next is known
    bool is_near = false;  // it lies near enough to that fit
    bool is_member = false;
  };
  void start(Index centre, Index seed);
  bool accepts(Index facet, const Limits& limits);
  bool is_near(Index v, double tangent);
  bool add_facet(Index facet);
  bool is_large() const;
  void push(Index facet, double distance);
  Index pop();

  const std::vector<Vec3>& points_;
  const FacetMesh& mesh_;
  const std::vector<double>& spacing_;
  double roughness_;
  Patch patch_;                                     // that grows
  std::vector<std::pair<double, Index>> frontier_;  // a heap, nearest first
  SmallSet seen_;                                   // facets
  SmallMap<Reached> reached_;
  PatchFit fit_;
  int fits_ = 0;  // of the patch so far
};

}  // namespace arris
