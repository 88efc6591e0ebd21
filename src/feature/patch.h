// Grows one smooth patch of facets round a point and fits a quadric to its vertices.
#pragma once

#include <vector>

#include "feature/facets.h"
#include "feature/local_surface.h"

namespace arris {

struct Patch {
  std::vector<Index> members;  // points, the centre first
  std::vector<Index> facets;
  LocalSurface surface;
};

// Takes facets nearest first while they agree with the fit so far: a plane, from `quadric_members`
// points on a quadric.
class PatchGrower {
 public:
  // Holds on to all three.
  PatchGrower(const std::vector<Vec3>& points, const FacetMesh& mesh,
              const std::vector<double>& spacing);

  // The patch round `centre` that starts with facet `seed` of its star and leans from its fit by
  // `angle` (radians) at most.
  Patch grow(Index centre, Index seed, double angle) const;

  // Enough members on a wide enough side of the centre to be more than a bevel.
  bool is_large(const Patch& patch, Index centre) const;

 private:
  bool accepts_facet(const Patch& patch, Index f, double angle) const;
  void add_facet(Patch& patch, Index f) const;
  void fit(Patch& patch, bool quadric, const std::vector<double>& trust) const;
  double polish(Patch& patch, bool quadric) const;
  Vec3 facet_normal(Index f) const;

  const std::vector<Vec3>& points_;
  const FacetMesh& mesh_;
  const std::vector<double>& spacing_;
};

}  // namespace arris
