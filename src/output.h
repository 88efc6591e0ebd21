// The user's frame and attributes back on what the pipeline made.
#pragma once

#include <vector>

#include "arris/report.h"
#include "arris/types.h"
#include "cloud/prepare.h"
#include "seed/seeds.h"
#include "tetra/tet_mesh.h"

namespace arris {

// The boundary of the labels. Vertices that are samples have the attributes of their input point
// and, unless the noise stage moved them, its coordinates bit for bit; background points have
// attribute value 0.
Mesh output_mesh(const PointCloud& cloud, const Samples& samples, const TetMesh& mesh,
                 const Labels& labels);

// The inside tetrahedra, alike.
TetVolume output_volume(const PointCloud& cloud, const Samples& samples, const TetMesh& mesh,
                        const Labels& labels);

// Seed confidence of every mesh vertex; that of a background vertex is 0.
std::vector<float> output_confidence(const Mesh& mesh, const Samples& samples, const Seeds& seeds);

// The counts, frame and confidence of the report.
void fill_counts(const PointCloud& cloud, const Samples& samples, const TetMesh& mesh,
                 const std::vector<double>& spacing, const Seeds& seeds, Report& report);

}  // namespace arris
