// Points on the smooth surface between the samples, where it leaves the chords.
#pragma once

#include <vector>

#include "arris/types.h"
#include "base/job.h"

namespace arris {

// A point over the middle of an edge of a mesh.
struct RefinePoint {
  Vec3 position;
  Vec3 foot;                  // the middle of the edge
  double spacing = 0;         // h there, half of that at the ends
  Index near = no_index;      // one of the ends
  std::vector<Vec3> normals;  // outward, of the surface or, on a feature, the two that it lies on
};

// Which edges take a point, in units of spacing.
struct RefineWish {
  double shortest = 0;  // shorter edges take none
  // Nor do those over which the surface stands off by less: it halves no error that is seen.
  double least_sag = 0.002;
};

// For the edges of a closed mesh over whose middle the sensed surface stands off: the point of the
// surface there, as far as the fit can be believed. Edges shorter than `shortest`, in units of
// spacing, take none, but where those of features must be halved for points beside them. The
// surface is sensed by jets of third order, fitted to vertices that are reached without crossing a
// feature; over an edge of a feature the point lies on the surfaces of both sides. Edges of
// features are also halved where a new point enters their diametral ball, as Delaunay meshes would
// lose them otherwise (Ruppert, "A Delaunay refinement algorithm for quality 2-dimensional mesh
// generation", 1995). `spacing`: h > 0 per vertex; `roughness`: a length by which vertices lie off
// the surface. O(n log n), parallel; the result does not depend on the number of threads.
std::vector<RefinePoint> refine_points(const Mesh& mesh, const std::vector<double>& spacing,
                                       double roughness, const RefineWish& wish, Job& job);

}  // namespace arris
