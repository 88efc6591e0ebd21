// Plain measurements of triangle meshes, written independently of the library so that tests may
// use them as an oracle. Everything here takes closed meshes and is exact up to rounding.
#pragma once

#include <cstddef>
#include <vector>

#include "arris/types.h"

namespace arris::truth {

// The bounding box of points.
struct Bounds {
  Vec3 low, high;
  double diagonal() const;
  Vec3 centre() const;
};
Bounds bounds_of(const std::vector<Vec3>& points);  // must not be empty

// One side of an edge of any mesh.
struct HalfEdge {
  Index a = no_index, b = no_index;  // a < b
  bool forward = true;               // whether the triangle walks it from a to b
  Index triangle = no_index;
};

// Sorted by (a, b), forward ones first, then by triangle. O(n log n).
std::vector<HalfEdge> sorted_half_edges(const Mesh& mesh);

// An edge of a closed, oriented mesh: triangle `left` walks it from a to b, `right` from b to a.
struct Edge {
  Index a = no_index, b = no_index;  // a < b
  Index left = no_index, right = no_index;
};

// All edges, sorted by (a, b). Throws std::invalid_argument unless every edge has exactly two
// triangles that walk it in opposite ways. O(n log n).
std::vector<Edge> edges(const Mesh& mesh);

// Throws std::invalid_argument unless the mesh is closed, consistently oriented and the triangles
// round every vertex are one fan. O(n log n).
void require_manifold(const Mesh& mesh);

// Unnormalised normal of a triangle: its length is twice the area.
Vec3 normal(const Mesh& mesh, Index triangle);

// The angle pi - theta by which the surface turns at an edge, in (-pi, pi]: 0 where flat, positive
// where convex, negative where concave.
double turn(const Mesh& mesh, const Edge& edge);

double area(const Mesh& mesh);
double volume(const Mesh& mesh);                // signed: positive if oriented outwards
double total_mean_curvature(const Mesh& mesh);  // sum over edges of length * |pi - theta| / 2
std::size_t components(const Mesh& mesh);       // by shared vertices
long euler(const Mesh& mesh);                   // V - E + F, over the vertices that are used

// The numbers of all triangles, for a BoxTree of them.
std::vector<Index> all_triangles(const Mesh& mesh);

// a and b must differ.
double distance_to_segment(Vec3 p, Vec3 a, Vec3 b);
// Distance to a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
double distance_to_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c);
// Distance to the nearest triangle by trying all of them.
double distance_to_mesh(Vec3 p, const Mesh& mesh);

}  // namespace arris::truth
