#include "tetra/locate.h"

#include "tetra/predicates.h"

namespace arris {

Tet locate(const TetMesh& mesh, Vec3 p, Tet hint) {
  Tet t = mesh.is_finite(hint) ? hint : 0, from = no_tet;
  for (;;) {
    const auto& v = mesh.vertices[t];
    Tet next = t;
    for (std::size_t i = 0; i < 4 && next == t; ++i) {
      if (mesh.neighbours[t][i] == from) continue;  // p is on this side of that facet
      const auto& k = facet_corners[i];
      const auto corner = [&](int c) { return mesh.points[v[static_cast<std::size_t>(c)]]; };
      // Corners run counter-clockwise seen from outside: positive means p is beyond the facet.
      if (orient3d(corner(k[0]), corner(k[1]), corner(k[2]), p) > 0) next = mesh.neighbours[t][i];
    }
    if (next == t || !mesh.is_finite(next)) return next;
    from = t;
    t = next;
  }
}

}  // namespace arris
