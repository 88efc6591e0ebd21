// From labels to the mesh: the facets between inside and outside, and the solid they enclose.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arris/types.h"
#include "tetra/tet_mesh.h"

namespace arris {

// The facets between inside and outside, oriented outwards, as indices of TetMesh::points.
// O(tetrahedra).
std::vector<Triangle> boundary_triangles(const TetMesh& mesh, const Labels& labels);

// 1 at the points that are corners of the triangles; there are `points` of them. O(points +
// triangles).
std::vector<std::uint8_t> corners_of(const std::vector<Triangle>& triangles, std::size_t points);

// Triangles oriented outwards over the points of the TetMesh that they use. Vertices keep the order
// of the points; `point` says which each is. O(tetrahedra).
struct ExtractedSurface {
  std::vector<Index> point;         // per vertex: index into TetMesh::points
  std::vector<Triangle> triangles;  // indices of vertices
};
ExtractedSurface extract_surface(const TetMesh& mesh, const Labels& labels);

// The inside tetrahedra over the points they use, alike.
struct ExtractedSolid {
  std::vector<Index> point;
  std::vector<std::array<Index, 4>> tetrahedra;
};
ExtractedSolid extract_solid(const TetMesh& mesh, const Labels& labels);

}  // namespace arris
