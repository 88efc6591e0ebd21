// How thin the thinnest bar, tunnel or crumb is.
#pragma once

#include <cstddef>

#include "arris/types.h"

namespace arris::truth {

// The least radius of a ball, in the unit of the mesh, round a point of the surface in which the
// surface, as far as it is joined to the point there, is no disc, nor in the ball three times as
// large: it goes round a bar, a tunnel or a neck, or is a whole crumb. (In the larger ball that
// round a tip ends in a disc.) The radii tried are three times the chords along the inward and the
// outward normal, of so many uniform points. Infinity if none below `reach` is found. The mesh must
// be closed and manifold.
double measure_necks(const Mesh& mesh, double reach, std::size_t points);

}  // namespace arris::truth
