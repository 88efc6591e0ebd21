// Colours of errors.
#pragma once

#include <array>

namespace arris::compare {

// viridis (van der Walt, Smith, Firing, 2015; CC0): perceptually uniform, and in order also for the
// colour-blind and in grey. t in [0, 1], clamped, from dark blue to yellow; sRGB, 0 to 1.
std::array<double, 3> viridis(double t);

}  // namespace arris::compare
