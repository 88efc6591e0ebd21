#include "swap/energy_change.h"

#include "energy/curvature.h"

namespace arris {
namespace {

bool has(unsigned mask, int i) {
  return (mask >> i & 1u) != 0;
}
Index vertex(const TetMesh& mesh, Tet t, int i) {
  return mesh.vertices[t][static_cast<std::size_t>(i)];
}

void add_polyhedral(const Boundary& boundary, const EnergyModel& model, Tet t, unsigned mask,
                    Change& change) {
  const TetMesh& mesh = boundary.mesh();
  std::array<Vec3, 4> normal;  // out of t
  for (int i = 0; i < 4; ++i) normal[static_cast<std::size_t>(i)] = facet_normal(mesh, t, i);
  for (std::size_t e = 0; e < 6; ++e) {
    const double cost = edge_cost(mesh, model, vertex(mesh, t, edge_corners[e][0]),
                                  vertex(mesh, t, edge_corners[e][1]));
    int a = edge_corners[5 - e][0], b = edge_corners[5 - e][1];  // the two facets at the edge
    const Vec3 na = normal[static_cast<std::size_t>(a)], nb = normal[static_cast<std::size_t>(b)];
    if (has(mask, a) == has(mask, b)) {  // the edge leaves the surface, or enters it
      change.add(cost * turning_angle(na, nb), has(mask, a) ? -1 : 1);
      continue;
    }
    // The edge stays, and its facet in t changes from a to b or back; the one it meets is at the
    // other end of the wedge of t's label.
    if (has(mask, b)) std::swap(a, b);
    const EdgeStep end = last_of_label(mesh, boundary.labels(), {t, a, b});
    const Vec3 other = facet_normal(mesh, end.t, end.out);
    change.add(cost * turning_angle(normal[static_cast<std::size_t>(a)], other), -1);
    change.add(cost * turning_angle(-normal[static_cast<std::size_t>(b)], other), 1);
  }
}

// The boundary facets round vertex `corner` of t that are not facets of t. `first` is a boundary
// facet of t at that vertex.
VertexCurvature rest_of_fan(const Boundary& boundary, const EnergyModel& model, Tet t, int corner,
                            int first) {
  const TetMesh& mesh = boundary.mesh();
  const Index v = vertex(mesh, t, corner);
  VertexCurvature sum;
  int pivot = 0;  // a corner of facet `first` other than v
  while (pivot == corner || pivot == first) ++pivot;
  EdgeStep facet{t, 0, first};
  Index hinge = vertex(mesh, t, pivot);  // turn about the edge (v, hinge) ...
  do {
    const int c = corner_of(mesh, facet.t, v), h = corner_of(mesh, facet.t, hinge);
    const int opposite = 6 - facet.out - c - h;
    facet = last_of_label(mesh, boundary.labels(), {facet.t, facet.out, opposite});
    hinge = vertex(mesh, facet.t, facet.in);  // ... then about the next
    if (facet.t == t) continue;
    const auto terms = facet_curvature(mesh, model, facet.t, facet.out);
    const auto& corners = facet_corners[static_cast<std::size_t>(facet.out)];
    for (std::size_t k = 0; k < 3; ++k)
      if (vertex(mesh, facet.t, corners[k]) == v) sum += terms[k];
  } while (facet.t != t || facet.out != first);
  return sum;
}

void add_cotangent(const Boundary& boundary, const EnergyModel& model, Tet t, unsigned mask,
                   Change& change) {
  const TetMesh& mesh = boundary.mesh();
  std::array<std::array<VertexCurvature, 3>, 4> terms;
  for (int i = 0; i < 4; ++i)
    terms[static_cast<std::size_t>(i)] = facet_curvature(mesh, model, t, i);
  for (int corner = 0; corner < 4; ++corner) {
    int first = 0;  // a boundary facet of t at the corner, if there is one
    while (first < 4 && (first == corner || !has(mask, first))) ++first;
    VertexCurvature before, after;
    if (first < 4) before = after = rest_of_fan(boundary, model, t, corner, first);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        if (facet_corners[i][k] == corner)
          (has(mask, static_cast<int>(i)) ? before : after) += terms[i][k];
    change.add(before.cost(model), -1);
    change.add(after.cost(model), 1);
  }
}

}  // namespace

Change flip_change(const Boundary& boundary, const EnergyModel& model,
                   const FidelityCosts& fidelity, Tet t) {
  const unsigned mask = boundary.facets(t);
  Change change;
  for (int i = 0; i < 4; ++i) change.add(fidelity(t, i), has(mask, i) ? -1 : 1);
  if (model.curvature == Curvature::cotangent)
    add_cotangent(boundary, model, t, mask, change);
  else
    add_polyhedral(boundary, model, t, mask, change);
  return change;
}

}  // namespace arris
