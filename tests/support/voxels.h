// Surfaces of unit cubes over one array of points, so that several share their facets.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "arris/types.h"

namespace arris::test {

// Where cubes are, by the coordinates of their low corner.
using Solid = std::function<bool(int, int, int)>;

// Points (x, y, z) with 0 <= x, y, z <= size, x fastest.
class Voxels {
 public:
  explicit Voxels(int size) : size_(size) {}

  Index point(int x, int y, int z) const {
    return static_cast<Index>(x + (size_ + 1) * (y + (size_ + 1) * z));
  }

  std::vector<Vec3> points() const {
    std::vector<Vec3> points;
    for (int z = 0; z <= size_; ++z)
      for (int y = 0; y <= size_; ++y)
        for (int x = 0; x <= size_; ++x)
          points.push_back(
              {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
    return points;
  }

  // Closed, oriented outwards; a 2-manifold unless cubes touch in an edge or a corner only.
  std::vector<Triangle> surface(const Solid& solid) const {
    const auto is_solid = [&](std::array<int, 3> c) {
      for (int i : c)
        if (i < 0 || i >= size_) return false;
      return solid(c[0], c[1], c[2]);
    };
    std::vector<Triangle> triangles;
    for (int z = 0; z < size_; ++z)
      for (int y = 0; y < size_; ++y)
        for (int x = 0; x < size_; ++x)
          if (is_solid({x, y, z}))
            for (std::size_t axis = 0; axis < 3; ++axis)
              for (int side : {0, 1}) {
                std::array<int, 3> across{x, y, z};
                across[axis] += side ? 1 : -1;
                if (!is_solid(across)) add_square({x, y, z}, axis, side, triangles);
              }
    return triangles;
  }

 private:
  void add_square(std::array<int, 3> low, std::size_t axis, int side,
                  std::vector<Triangle>& triangles) const {
    std::array<Index, 4> ring{};
    constexpr int round[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<int, 3> c = low;
      c[axis] += side;
      c[(axis + 1) % 3] += round[k][0];
      c[(axis + 2) % 3] += round[k][1];
      ring[side ? k : 3 - k] = point(c[0], c[1], c[2]);
    }
    // The same diagonal from either side, so that facets differ by where the solid is alone.
    const std::size_t s = side ? 0 : 3;
    triangles.push_back({ring[s], ring[(s + 1) % 4], ring[(s + 2) % 4]});
    triangles.push_back({ring[s], ring[(s + 2) % 4], ring[(s + 3) % 4]});
  }

  int size_;
};

}  // namespace arris::test
