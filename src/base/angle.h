// Angles are radians inside arris; constants are written in degrees.
#pragma once

#include <numbers>

namespace arris {

constexpr double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}
constexpr double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

}  // namespace arris
