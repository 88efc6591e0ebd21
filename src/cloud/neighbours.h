// The nearest neighbours of every point of a cloud from which points are taken out.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/job.h"
#include "base/vec.h"
#include "cloud/flatness.h"

namespace arris {

// How flat point p and the nearest of its neighbours lie; `without` is not counted.
Flatness flatness_round(const std::vector<Vec3>& points, Index p, std::span<const Index> neighbours,
                        Index without);

class Neighbours {
 public:
  static constexpr std::size_t count = 16;  // per point
  static constexpr std::size_t rank = 6;    // reach: the distance to this neighbour, counted from 1
  static constexpr std::size_t patch = 8;   // neighbours that span the plane at a point

  // Of more than `count` distinct points, which must outlive it. O(n log n), 100 bytes a point.
  Neighbours(const std::vector<Vec3>& points, Job& job);

  // Those of p that are left, nearest first, without p.
  const std::array<Index, count>& of(Index p) const noexcept { return of_[p]; }
  std::span<const Index> nearest(Index p) const noexcept {
    return std::span<const Index>(of_[p]).first<patch>();
  }
  double reach(Index p) const noexcept { return reach_[p]; }
  double nearest_distance(Index p) const { return distance(points_[p], points_[of_[p].front()]); }
  bool gone(Index p) const noexcept { return gone_[p] != 0; }
  Vec3 point(Index p) const noexcept { return points_[p]; }
  std::size_t size() const noexcept { return points_.size(); }
  std::size_t left() const noexcept { return left_; }

  // How flat p and its nearest neighbours lie; `without` is not counted.
  Flatness flatness_at(Index p, Index without = no_index) const {
    return flatness_round(points_, p, of_[p], without);
  }

  // Takes out the marked points and finds new neighbours for those that lost one. At most left() -
  // count - 1 may be marked.
  void remove(const std::vector<std::uint8_t>& marked, Job& job);

 private:
  void find(const std::vector<Index>& whom, Job& job);

  const std::vector<Vec3>& points_;
  std::size_t left_;
  std::vector<std::uint8_t> gone_;
  std::vector<std::array<Index, count>> of_;
  std::vector<double> reach_;
};

}  // namespace arris
