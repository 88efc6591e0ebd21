// Where a ray meets a mesh.
#pragma once

#include <limits>

#include "arris/types.h"
#include "surface/box_tree.h"

namespace arris::truth {

struct Hit {
  double distance = std::numeric_limits<double>::infinity();  // if nothing is hit
  Vec3 normal;                                                // unit
};

// Keeps a reference to the mesh.
class RayCaster {
 public:
  explicit RayCaster(const Mesh& mesh);

  // Along a unit direction, no farther than `limit`, or a little more. Hits nearer than a millionth
  // of the diagonal are the start itself. A ray is followed in stretches of doubling length, so
  // that only triangles near it are looked at.
  Hit first_hit(Vec3 from, Vec3 direction,
                double limit = std::numeric_limits<double>::infinity()) const;

 private:
  Hit nearest_between(Vec3 from, Vec3 direction, double begin, double end) const;
  double distance_along(Vec3 from, Vec3 direction, const Triangle& t) const;

  const Mesh& mesh_;
  double diagonal_;
  BoxTree tree_;
};

}  // namespace arris::truth
