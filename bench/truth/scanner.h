// A virtual range scanner.
#pragma once

#include <cstddef>
#include <cstdint>

#include "arris/types.h"
#include "truth/samplers.h"

namespace arris::truth {

// Looks at the mesh from `views` eyes spread evenly round it (a Fibonacci sphere, each moved a
// little by the seed), 2.5 diagonals from its centre. Each takes a square perspective range image
// that just holds the mesh: a ray through every pixel, of which the first hit counts, from either
// side of the surface. Hits at more than 80 degrees from the normal are lost, as a real scanner
// loses them. What no eye sees has no points. The pixels are as many as give at least n hits; of
// these n are drawn at random. Directions are those of the rays.
// Throws std::invalid_argument if nothing is seen. O(views * triangles + hits) per image size
// tried, of which there are few.
Samples scan(const Mesh& mesh, std::size_t n, int views, std::uint64_t seed);

}  // namespace arris::truth
