// A random generator that gives the same numbers with every compiler and standard library.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/vec.h"

namespace arris::truth {

// splitmix64 (Steele, Lea, Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  // Strictly between 0 and 1.
  double unit() { return (static_cast<double>(next() >> 12) + 0.5) * 0x1p-52; }

  // In [0, n).
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }

  // In [low, high).
  double between(double low, double high) { return low + (high - low) * unit(); }

  // Uniform on the unit sphere: by rejection, since sin and cos differ in their last bits too.
  Vec3 direction() {
    for (;;) {
      const double x = 2 * unit() - 1, y = 2 * unit() - 1, z = 2 * unit() - 1;
      const double l = length(Vec3{x, y, z});
      if (l <= 1 && l > 1e-3) return (1 / l) * Vec3{x, y, z};
    }
  }

  // Nearly normal, mean 0, deviation 1, never beyond 6: the sum of twelve uniforms, since the
  // usual formulas need log and cos, whose last bits differ between libraries.
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += unit();
    return sum;
  }

 private:
  std::uint64_t state_;
};

}  // namespace arris::truth
