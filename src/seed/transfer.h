// Seeds for one tetrahedral mesh from the labels of another over the same samples.
#pragma once

#include "seed/seeds.h"
#include "tetra/tet_mesh.h"

namespace arris {

// An added point lies well away from the samples, so the label of the tetrahedron of `coarse` that
// holds it is that of all its neighbourhood: a tetrahedron of `fine` whose added points agree is
// firm and takes their label. One without added points, or with some of both sides, takes the label
// of the tetrahedron of `coarse` that holds its centroid, and is not firm. Confidence and
// contradiction are those of `seeds`.
// Complexity: near-linear, as both meshes are numbered along the same curve.
Seeds transfer_seeds(const TetMesh& coarse, const Labels& labels, const Seeds& seeds,
                     const TetMesh& fine, Job& job);

// The same where the points of `fine` are those of `coarse` and then points added on the surface:
// every tetrahedron takes the label of the tetrahedron of `coarse` that it was (`former`, or
// no_tet) or that holds its centroid, and is firm if its ball is large, as in find_seeds. Round an
// added point, and one facet beyond, the label that its place has in `coarse` is a hint unless it
// is firm: the surface is expected to move there. Long flat tetrahedra are free; slivers that were
// there before, and those that are `settled` (1, per tetrahedron of `fine`), keep their label.
// `told`: what else is known of each finite tetrahedron of `fine`, firmly unless it is a sliver;
// seed_free for nothing. `near`: for each added point one of `coarse` near it.
Seeds follow_seeds(const TetMesh& coarse, const Labels& labels, const Seeds& seeds,
                   const TetMesh& fine, const std::vector<Tet>& former,
                   const std::vector<Index>& near, const std::vector<double>& spacing,
                   const std::vector<std::uint8_t>& settled, const std::vector<Seed>& told,
                   Job& job);

}  // namespace arris
