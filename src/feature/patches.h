// The smooth patches between the curves.
#pragma once

#include "arris/features.h"
#include "feature/network.h"

namespace arris {

// Fills `patch` and `patches` of the result: triangles that are joined through edges outside the
// network are of one patch. Numbered by lowest triangle. O(n).
void label_patches(const Network& network, FeatureNetwork& result);

}  // namespace arris
