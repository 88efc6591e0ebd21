// The two measures of the mean curvature of the boundary of the labels, as terms of E.
//
// Polyhedral: the total mean curvature of a polyhedron is the sum over its edges of
// length x |pi - interior dihedral angle| / 2 (Steiner 1840). It needs no vertex normals, is finite
// on slivers, and a flip of one tetrahedron changes it at six edges only.
//
// Cotangent: the discrete Laplace-Beltrami operator of the paper, eq. 7-10, with the mixed areas of
// Meyer, Desbrun, Schroeder, Barr (2002).
#pragma once

#include "base/vec.h"
#include "energy/facet.h"
#include "energy/model.h"
#include "tetra/edge_walk.h"
#include "tetra/tet_mesh.h"

namespace arris {

// The angle in [0, pi] between two normals of any length, which is |pi - interior dihedral angle|
// if both point out of the solid (or both into it). 0 if one of them is null.
inline double turning_angle(Vec3 a, Vec3 b) {
  const double sine = length(cross(a, b)), cosine = dot(a, b);
  return sine == 0 && cosine == 0 ? 0 : std::atan2(sine, cosine);  // atan2(0, -0.0) would be pi
}

// λ l / (2 h) of the edge uv: E per radian that the boundary turns at it; 0 with Curvature::area.
// Dimensionless.
double edge_cost(const TetMesh& mesh, const EnergyModel& model, Index u, Index v);

// The sums over the boundary facets round a vertex from which its curvature follows. They are
// additive over facets.
struct VertexCurvature {
  Vec3 turning;       // half the sum of eq. 7, in units of length
  double area = 0;    // mixed area, the A of eq. 8
  double weight = 0;  // Σ S / (3 h) over the facets: what |κ| of the vertex is multiplied with

  VertexCurvature& operator+=(const VertexCurvature& o) {
    turning = turning + o.turning;
    area += o.area;
    weight += o.weight;
    return *this;
  }
  // |κ| = |K| / 2, in units of one over a length; 0 off the surface.
  double mean_curvature() const { return area > 0 ? 0.5 * length(turning) / area : 0; }
  // λ |κ| Σ S / (3 h): the share of the vertex in Σ λ |κ_i| S_i / h_i, eq. 9 and 10. Dimensionless.
  double cost(const EnergyModel& model) const { return model.lambda * mean_curvature() * weight; }
};

// What facet i of t adds to each of its corners, in the order of facet_corners. Finite whatever the
// shape of the facet. The facet must not be infinite.
std::array<VertexCurvature, 3> facet_curvature(const TetMesh& mesh, const EnergyModel& model, Tet t,
                                               int i);

// Total mean curvature of the boundary of the labels as a polyhedron, in units of length: 3 pi for
// a unit cube, 4 pi r for a ball. An edge where several wedges of the inside meet counts once per
// wedge. Complexity: O(size of the mesh).
double total_mean_curvature(const TetMesh& mesh, const Labels& labels);

// The curvature part of E for the whole boundary of the labels, dimensionless. The boundary must be
// a 2-manifold. Complexity: O(size of the mesh).
double polyhedral_energy(const TetMesh& mesh, const EnergyModel& model, const Labels& labels,
                         unsigned threads = 1);
double cotangent_energy(const TetMesh& mesh, const EnergyModel& model, const Labels& labels);

}  // namespace arris
