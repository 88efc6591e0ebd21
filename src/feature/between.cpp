#include "feature/between.h"

#include "base/parallel.h"
#include "seed/shapes.h"
#include "tetra/geometry.h"

namespace arris {
namespace {

// In units of spacing: what is nearer to a surface is on neither side of it. Planes are exact;
// quadrics miss what bends more than they. Measured: with 0.1 for planes the tips of wedges of 27
// degrees stay cut off, with 0.02 for quadrics smooth models gain edges.
constexpr double off_plane = 0.02, off_quadric = 0.15;
// Tetrahedra with longer edges, in units of spacing, reach beyond what was sensed.
constexpr double longest = 3;

Seed side_of(const LocalSurface& s, Vec3 p, double h, double roughness) {
  const double clear = (s.is_plane() ? off_plane : off_quadric) * h + 2 * roughness;
  const double d = s.distance(p);
  return d < -clear ? seed_inside : d > clear ? seed_outside : seed_free;
}

Seed between(const TetMesh& mesh, Tet t, double h, const SurfacesAt& surfaces_at,
             double roughness) {
  const Vec3 p = centroid(mesh, t);
  Seed all = seed_free;
  for (Index v : mesh.vertices[t]) {
    const std::span<const LocalSurface> surfaces = surfaces_at(v);
    if (surfaces.empty()) return seed_free;
    for (const LocalSurface& s : surfaces) {
      const Seed side = side_of(s, p, h, roughness);
      if (side == seed_free || (all != seed_free && side != all)) return seed_free;
      all = side;
    }
  }
  return longest_edge(mesh, t) <= longest * h ? all : seed_free;
}

}  // namespace

std::vector<Seed> tetrahedra_between(const TetMesh& mesh, const std::vector<double>& spacing,
                                     const SurfacesAt& surfaces_at, double roughness, Job& job) {
  job.tick(0);
  std::vector<Seed> result(mesh.finite);
  parallel_for(mesh.finite, job.threads(), [&](std::size_t i) {
    const auto t = static_cast<Tet>(i);
    result[t] = between(mesh, t, mean_spacing(mesh, spacing, t), surfaces_at, roughness);
  });
  return result;
}

}  // namespace arris
