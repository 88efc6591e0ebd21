// Random solids: primitives at random poses, united, subtracted and intersected.
#pragma once

#include <cstdint>
#include <string>

#include "arris/types.h"
#include "truth/thickness.h"

namespace arris::truth {

struct CsgModel {
  Mesh mesh;           // diagonal about 1 to 4
  std::string recipe;  // "box + cylinder - sphere & wedge"
  Thickness thickness;
  int retries = 0;  // draws that were given up: see random_csg
};

// Two to six boxes, prisms, pyramids, cylinders, cones, frustums, spheres or wedges, round ones
// with `resolution` segments a circle. A draw is given up, and the next one made, if the result is
// not a closed 2-manifold in doubles (see combine), if it changes next to nothing, or if anything
// is left that is thinner than 4 % of the diagonal, so that clouds of about 20 thousand samples can
// hold every part. Every seed gives a valid model, always the same. A second
// or a few.
CsgModel random_csg(std::uint64_t seed, int resolution = 96);

}  // namespace arris::truth
