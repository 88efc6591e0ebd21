// Points in cubic cells: those near a place, while more are added.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "arris/types.h"

namespace arris {

class PointGrid {
 public:
  // Visits reach one cell far: `cell` is the largest radius that can be asked for. > 0.
  explicit PointGrid(double cell) : cell_(cell) {}

  void add(Vec3 x, Index i) { cells_[key(coordinates(x))].push_back(i); }

  // body(i) for every point in the 27 cells round x, in a fixed order.
  template <class Body>
  void visit(Vec3 x, Body&& body) const {
    const auto c = coordinates(x);
    for (std::int64_t i = -1; i <= 1; ++i)
      for (std::int64_t j = -1; j <= 1; ++j)
        for (std::int64_t k = -1; k <= 1; ++k) {
          const auto cell = cells_.find(key({c[0] + i, c[1] + j, c[2] + k}));
          if (cell == cells_.end()) continue;
          for (Index p : cell->second) body(p);
        }
  }

 private:
  using Coordinates = std::array<std::int64_t, 3>;
  Coordinates coordinates(Vec3 x) const {
    return {coordinate(x.x), coordinate(x.y), coordinate(x.z)};
  }
  // Far outside what an integer holds all cells are one.
  std::int64_t coordinate(double x) const {
    return static_cast<std::int64_t>(std::clamp(std::floor(x / cell_), -0x1p60, 0x1p60));
  }
  // Cells that share a key only cost time: who visits looks at distances.
  static std::uint64_t key(const Coordinates& c) {
    std::uint64_t hash = 0;
    for (std::int64_t x : c) hash = (hash ^ static_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15u;
    return hash ^ (hash >> 32);
  }

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<Index>> cells_;
};

}  // namespace arris
