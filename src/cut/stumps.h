// Where the samples leave two ends of one part facing each other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/job.h"
#include "seed/seeds.h"
#include "tetra/facet_stars.h"
#include "tetra/tet_mesh.h"

namespace arris {

// The surface between the labels, as facets round its points.
struct CutSurface {
  struct Facet {
    Tet inside;
    std::size_t i;  // which facet of `inside`
    std::array<Index, 3> corners;
    Vec3 normal;   // outward, unit; null if the facet has no area
    double area;   // in squares of the spacing
    double reach;  // largest distance of one of its points to a corner, in units of spacing
  };
  std::vector<Facet> facets;
  std::size_t points = 0;
  FacetStars stars;

  std::span<const Index> round(Index v) const { return stars[v]; }
};
CutSurface cut_surface_of(const TetMesh& mesh, const std::vector<double>& spacing,
                          const Labels& labels);
// The part of it that find_stumps looks at: it finds the same there, by other numbers. Most
// surfaces have little of it.
CutSurface surface_near_gaps(const TetMesh& mesh, const std::vector<double>& spacing,
                             const Labels& labels);

// A cap is a region of facets that span gaps, at whose rim the surface turns: an end that no sample
// closes. Two that face each other, not far apart for their size, and that see each other, are the
// stumps of one part whose sides are missing all round between them.
struct Stumps {
  struct Axis {
    std::size_t from, to;  // caps, by number
    std::array<Vec3, 2> ends;
  };
  std::vector<std::uint8_t> cap;  // per facet of the surface: in a cap that faces another
  std::vector<Axis> axes;
  std::size_t caps = 0;  // how many numbers there are
};
Stumps find_stumps(const TetMesh& mesh, const CutSurface& surface);

}  // namespace arris
