// The one call that does the whole job.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arris/context.h"
#include "arris/error.h"
#include "arris/features.h"
#include "arris/options.h"
#include "arris/report.h"
#include "arris/types.h"

namespace arris {

struct Reconstruction {
  Mesh mesh;                         // certified: see Report::certificate; open if Options::trim
  TetVolume volume;                  // empty unless Options::tetrahedra
  std::vector<float> confidence;     // per mesh vertex, [0, 1]: share of agreeing seed evidence
  std::vector<float> support;        // per triangle, (0, 1]: spacing / distance to the samples
  std::vector<std::uint8_t> filled;  // per triangle: 1 if it closes a gap that no sample supports
  FeatureNetwork features;           // of the mesh: sharp edges, corners, smooth patches
  Report report;
};

// Positions in, certified mesh out. The mesh is the boundary of a union of Delaunay tetrahedra of
// the distinct points, moved by what noise there is, and of points added on features. The result
// does not depend on the number of threads, nor on the order of the points except for which
// duplicate gives its attributes (the first). Errors: usage, bad_points, degenerate, no_surface,
// certificate, out_of_memory, cancelled. Complexity: O(n log n) time and at most 2.1 kB a point for
// points near a surface.
Result<Reconstruction> reconstruct(const PointCloud& cloud, const Options& options = {},
                                   const Context& context = {});

// Bytes that reconstruct will need at most for `points` points with these options: measured, then
// rounded up; see docs/architecture.md.
std::size_t forecast_memory(std::size_t points, const Options& options = {});

}  // namespace arris
