// The certificate: what arris promises of every mesh it writes, checked with exact predicates.
#pragma once

#include <cstdint>
#include <string>

#include "arris/context.h"
#include "arris/error.h"
#include "arris/types.h"

namespace arris {

// Counts of defects, all zero for a certified mesh. Coordinates are taken as exact doubles: every
// geometric decision uses exact predicates, none uses a tolerance.
struct Certificate {
  std::uint64_t vertices = 0, triangles = 0, edges = 0;
  std::uint64_t invalid_indices = 0;  // corners that name no vertex
  std::uint64_t non_finite_vertices = 0;
  std::uint64_t unreferenced_vertices = 0;  // reported, not a defect
  std::uint64_t degenerate_triangles = 0;   // repeated corner, or three collinear corners
  std::uint64_t boundary_edges = 0;         // one triangle
  std::uint64_t nonmanifold_edges = 0;      // three or more triangles
  std::uint64_t nonmanifold_vertices = 0;   // triangles round it are not one fan
  std::uint64_t misoriented_edges = 0;      // two triangles that walk it the same way
  std::uint64_t intersecting_pairs = 0;     // pairs of triangles that meet outside shared corners
  std::uint64_t inward_components = 0;      // components whose normals point into the solid
  std::uint64_t components = 0;             // by shared edges
  std::int64_t euler = 0;                   // V - E + F over referenced vertices
  double volume = 0;                        // signed, user's unit cubed
  double area = 0;

  bool closed() const noexcept { return boundary_edges == 0 && triangles > 0; }
  bool manifold() const noexcept { return nonmanifold_edges == 0 && nonmanifold_vertices == 0; }
  bool oriented() const noexcept { return misoriented_edges == 0 && inward_components == 0; }

  // All promises hold that make sense for a surface with a boundary, such as a trimmed mesh.
  bool sound() const noexcept {
    return triangles > 0 && invalid_indices == 0 && non_finite_vertices == 0 && manifold() &&
           oriented() && degenerate_triangles == 0 && intersecting_pairs == 0;
  }

  // All promises hold.
  bool ok() const noexcept { return sound() && closed() && volume > 0; }

  // The first defect with an example ("edge 12-17 has 3 triangles"), or empty.
  std::string first_defect;
};

// Examines any mesh. A component nested an odd depth inside others (a cavity) must be oriented
// towards the void it bounds, and is. Fails only with cancelled or out_of_memory; a bad mesh is a
// Certificate that is not ok().
// Complexity: O(n log n) for n triangles of bounded overlap.
Result<Certificate> check(const Mesh& mesh, const Context& context = {});

}  // namespace arris
