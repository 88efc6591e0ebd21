// Union, difference and intersection of solids, computed exactly and then rounded.
#pragma once

#include <cstdint>
#include <optional>

#include "arris/types.h"

namespace arris::truth {

enum class Operation : std::uint8_t { unite, subtract, intersect };

// a united with b, a without b, or what they share. Both must be closed, manifold, free of
// intersections and oriented outwards (towards the void in a cavity); so is the result, which is
// empty if nothing is left. Nothing if the exact result is not manifold (solids that touch in an
// edge or a point), or if rounding its corners to doubles spoils it: the library's own check must
// pass, and no triangle may be so narrow that its normal is lost. About O(n log n) for n triangles,
// of which those where the surfaces meet are dear.
std::optional<Mesh> combine(const Mesh& a, const Mesh& b, Operation operation);

}  // namespace arris::truth
