// Random numbers that depend on the seed and the number of the sample alone, so that samples can be
// drawn by any number of threads in any order.
#pragma once

#include <cstdint>

namespace arris::compare {

// splitmix64 (Steele, Lea, Flood, Fast splittable pseudorandom number generators, 2014).
class Draw {
 public:
  // The numbers of one sample. Different purposes take different streams.
  Draw(std::uint64_t seed, std::uint64_t stream, std::uint64_t sample)
      : state_(mixed(mixed(seed + golden) + mixed(stream + golden)) + mixed(sample)) {}

  // In [0, 1).
  double unit() { return static_cast<double>(mixed(state_ += golden) >> 11) * 0x1p-53; }

 private:
  static constexpr std::uint64_t golden = 0x9E3779B97F4A7C15u;
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace arris::compare
