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

// Grids of several sizes of cells, each with all points, so that a small radius meets small cells
// even where others ask for a large one.
class PointGrid {
 public:
  // The largest radius that can be asked for, > 0, and about the smallest.
  explicit PointGrid(double largest) : PointGrid(largest, largest) {}
  PointGrid(double largest, double smallest) {
    for (double cell = largest; grids_.empty() || (cell >= smallest && grids_.size() < most_grids);
         cell /= step)
      grids_.push_back({cell, {}});
  }

  void add(Vec3 x, Index i) {
    for (Grid& g : grids_) g.cells[key(g.coordinates(x))].push_back(i);
  }

  // body(i) for every point within `radius` of x, and others not far from it, in a fixed order,
  // until it returns false.
  template <class Body>
  void visit(Vec3 x, double radius, Body&& body) const {
    std::size_t level = 0;
    while (level + 1 < grids_.size() && grids_[level + 1].cell >= radius) ++level;
    const Grid& grid = grids_[level];
    const auto c = grid.coordinates(x);
    for (std::int64_t i = -1; i <= 1; ++i)
      for (std::int64_t j = -1; j <= 1; ++j)
        for (std::int64_t k = -1; k <= 1; ++k) {
          const auto cell = grid.cells.find(key({c[0] + i, c[1] + j, c[2] + k}));
          if (cell == grid.cells.end()) continue;
          for (Index p : cell->second)
            if (!body(p)) return;
        }
  }

 private:
  static constexpr double step = 4;  // between the sizes of two grids
  static constexpr std::size_t most_grids = 8;
  using Coordinates = std::array<std::int64_t, 3>;
  struct Grid {
    double cell;
    std::unordered_map<std::uint64_t, std::vector<Index>> cells;

    Coordinates coordinates(Vec3 x) const {
      return {coordinate(x.x), coordinate(x.y), coordinate(x.z)};
    }
    // Far outside what an integer holds all cells are one.
    std::int64_t coordinate(double x) const {
      return static_cast<std::int64_t>(std::clamp(std::floor(x / cell), -0x1p60, 0x1p60));
    }
  };
  // Cells that share a key only cost time: who visits looks at distances.
  static std::uint64_t key(const Coordinates& c) {
    std::uint64_t hash = 0;
    for (std::int64_t x : c) hash = (hash ^ static_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15u;
    return hash ^ (hash >> 32);
  }

  std::vector<Grid> grids_;  // by falling size of cells
};

}  // namespace arris
