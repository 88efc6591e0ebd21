#include "compare/colour_map.h"

#include <algorithm>
#include <cstddef>

namespace arris::compare {

std::array<double, 3> viridis(double t) {
  // Every sixteenth of the published map.
  static constexpr std::array<std::array<double, 3>, 17> colours = {{
      {0.2670, 0.0049, 0.3294},
      {0.2823, 0.0946, 0.4170},
      {0.2789, 0.1749, 0.4830},
      {0.2593, 0.2507, 0.5244},
      {0.2302, 0.3213, 0.5455},
      {0.2000, 0.3864, 0.5545},
      {0.1733, 0.4474, 0.5579},
      {0.1497, 0.5064, 0.5573},
      {0.1281, 0.5651, 0.5509},
      {0.1203, 0.6238, 0.5343},
      {0.1554, 0.6815, 0.5032},
      {0.2415, 0.7366, 0.4545},
      {0.3629, 0.7867, 0.3866},
      {0.5081, 0.8292, 0.2992},
      {0.6694, 0.8622, 0.1954},
      {0.8359, 0.8861, 0.1025},
      {0.9932, 0.9062, 0.1439},
  }};
  constexpr std::size_t steps = colours.size() - 1;
  const double at = std::clamp(t, 0.0, 1.0) * static_cast<double>(steps);
  const auto i = std::min(static_cast<std::size_t>(at), steps - 1);
  const double part = at - static_cast<double>(i);
  std::array<double, 3> colour{};
  for (std::size_t k = 0; k < 3; ++k)
    colour[k] = (1 - part) * colours[i][k] + part * colours[i + 1][k];
  return colour;
}

}  // namespace arris::compare
