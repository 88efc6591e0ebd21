// Where a mesh is wrong: distances to the truth as attributes and colours.
#pragma once

#include <memory>
#include <string>

#include "arris/context.h"
#include "arris/error.h"
#include "arris/types.h"

namespace arris::compare {

// The distance from any point to a mesh, both in the user's unit. Copies what it needs; may be
// asked from several threads at once.
class DistanceToMesh {
 public:
  // Errors: bad_points, unreadable, degenerate (as compare_meshes), out_of_memory. `name` is what
  // messages call the mesh.
  static Result<DistanceToMesh> make(const Mesh& mesh, const std::string& name,
                                     const Context& context = {});
  // O(log n) near the mesh.
  double operator()(Vec3 p) const;
  double diagonal() const;  // of the bounding box of the mesh

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

// The mesh with the distance of every vertex to the truth (user's unit) as attribute `distance`,
// and its colour as red, green and blue: viridis from 0 to `full` and yellow beyond. Attributes of
// these names are replaced. Vertices that are not finite get NaN. Errors: cancelled, out_of_memory.
Result<Mesh> error_map(const Mesh& mesh, const DistanceToMesh& truth, double full,
                       const Context& context = {});

}  // namespace arris::compare
