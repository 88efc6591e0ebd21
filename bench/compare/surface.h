// A mesh made ready to be compared: in the truth's unit, with areas, normals and a tree.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "arris/types.h"
#include "compare/nearest.h"

namespace arris::compare {

// The frame of a comparison: coordinates (p - centre) / diagonal, both of the bounding box of the
// truth, so that every length is a fraction of its diagonal.
struct UnitFrame {
  Vec3 centre;
  double diagonal = 1;
  Vec3 map(Vec3 p) const;
};

// Throws Failure: bad_points (no triangles, a used coordinate that is not finite or beyond 1e150),
// unreadable (a corner names no vertex). `name` is what messages call the mesh.
void require_surface(const Mesh& mesh, const std::string& name);

// Of a mesh that passed require_surface. Throws Failure: degenerate (all vertices are equal).
UnitFrame unit_frame(const Mesh& mesh, const std::string& name);

// Polygon soup: nothing is repaired. Degenerate triangles take no part in what is measured.
struct Surface {
  std::vector<Vec3> points;  // in the unit frame
  std::vector<Triangle> triangles;
  std::vector<Vec3> normals;             // per triangle, length 1; 0 if degenerate
  std::vector<Index> solid;              // the triangles that are not degenerate
  std::vector<double> area_until;        // per solid triangle: the area up to its end
  std::vector<Index> used;               // vertices that triangles name, ascending
  std::unique_ptr<NearestElement> tree;  // of the solid triangles

  double area() const { return area_until.back(); }
  bool is_solid(Index triangle) const { return squared_length_of_normal(triangle) > 0; }
  // The solid triangle, as an index into `solid`, in which `share` in [0, 1] of the area is passed.
  std::size_t solid_at(double share) const;

 private:
  double squared_length_of_normal(Index triangle) const {
    const Vec3 n = normals[triangle];
    return n.x * n.x + n.y * n.y + n.z * n.z;
  }
};

// Of a mesh that passed require_surface. Throws Failure: degenerate (no triangle has an area),
// bad_points (it lies beyond 1e150 diagonals). Complexity: O(n log n).
Surface make_surface(const Mesh& mesh, const UnitFrame& frame, const std::string& name,
                     unsigned threads);

}  // namespace arris::compare
