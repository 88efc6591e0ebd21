// Global minimization: the surface of least energy that separates the seeds (paper, section 3).
#pragma once

#include <vector>

#include "base/job.h"
#include "energy/model.h"
#include "seed/seeds.h"
#include "tetra/tet_mesh.h"

namespace arris {

struct SurfaceCut {
  Labels labels;           // per tetrahedron, infinite ones too
  double energy = 0;       // E of eq. 6, lengths in units of spacing
  std::uint64_t free = 0;  // tetrahedra that the cut decided
};

// One minimum cut of the dual graph. Firm seeds keep their label; the others prefer theirs (see
// seed_trust); unseeded tetrahedra are free. `curvature` is κ^n per point, or empty for κ^0 = 0.
// Throws Failure: cancelled, internal if flow and cut capacity disagree.
SurfaceCut cut_surface(const TetMesh& mesh, const EnergyModel& model, const Seeds& seeds,
                       const std::vector<double>& curvature, Job& job);

}  // namespace arris
