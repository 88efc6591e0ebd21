// How thin the parts of a solid are, so that its samples can be made dense enough.
#pragma once

#include <cstddef>

#include "arris/types.h"

namespace arris::truth {

// Lengths in the unit of the mesh; infinity where there is no such thing.
struct Thickness {
  // One percent of the surface lies on walls thinner than this: from there a ray along the inward
  // normal meets the surface again so soon, at a face within 15 degrees of parallel (so that the
  // two sides of a convex edge are no wall).
  double wall = 0;
  // The same of voids, by rays along the outward normal.
  double gap = 0;
  // The smallest diagonal of the bounding boxes of components, and of connected groups of sharp
  // edges (30 degrees): a crumb, a pinhole or a thin neck of which the rays see too little.
  double detail = 0;
  // What measure_clearance finds nearer than 8 % of the diagonal.
  double clearance = 0;
  // What measure_necks finds below 8 % of the diagonal.
  double neck = 0;

  double thinnest() const;
};

// Wall and gap are measured from 4000 points uniform on the surface, with a fixed seed. The mesh
// must be closed and oriented outwards. O(n log n), and short rays are cheap.
Thickness measure_thickness(const Mesh& mesh);

// Whether detail, clearance or neck is less than `length`, which may be 8 % of the diagonal at
// most: quick to say so.
bool has_thin_spots(const Mesh& mesh, double length);

// The number of samples whose spacing is a quarter of the thinnest part, and at most a fiftieth of
// the diagonal: that many points `blue` are dense enough to tell both sides of every part apart.
std::size_t dense_samples(const Mesh& mesh, const Thickness& thickness);

}  // namespace arris::truth
