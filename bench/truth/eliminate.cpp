#include "truth/eliminate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

#include "base/vec.h"

namespace arris::truth {
namespace {

// Points sorted into cubes of side `cell`, to find those within that distance.
class Grid {
 public:
  Grid(const std::vector<Vec3>& points, double cell) : points_(points), cell_(cell) {
    for (std::size_t i = 0; i < points.size(); ++i) entries_.push_back({key(points[i]), i});
    std::sort(entries_.begin(), entries_.end());
  }

  // visit(j, distance) for every other point j nearer than a cell.
  template <class Visit>
  void neighbours(std::size_t i, Visit visit) const {
    const Key centre = key(points_[i]);
    for (long x = -1; x <= 1; ++x)
      for (long y = -1; y <= 1; ++y) {
        // Cells that differ in z alone are consecutive.
        const Key first = {centre[0] + x, centre[1] + y, centre[2] - 1};
        const Key last = {first[0], first[1], centre[2] + 1};
        auto at = std::lower_bound(entries_.begin(), entries_.end(), Entry{first, 0});
        for (; at != entries_.end() && at->first <= last; ++at) {
          const double d = distance(points_[i], points_[at->second]);
          if (at->second != i && d < cell_) visit(at->second, d);
        }
      }
  }

 private:
  using Key = std::array<long, 3>;
  using Entry = std::pair<Key, std::size_t>;

  Key key(Vec3 p) const {
    return {std::lround(std::floor(p.x / cell_)), std::lround(std::floor(p.y / cell_)),
            std::lround(std::floor(p.z / cell_))};
  }

  const std::vector<Vec3>& points_;
  double cell_;
  std::vector<Entry> entries_;
};

// How much points at distance d crowd each other if `range` is where that ends (Yuksel, eq. 2).
double crowding(double d, double range) {
  if (d >= range) return 0;
  const double w = 1 - d / range, w2 = w * w, w4 = w2 * w2;
  return w4 * w4;
}

}  // namespace

std::vector<std::size_t> eliminate(const std::vector<Vec3>& points,
                                   const std::vector<double>& scale, std::size_t kept,
                                   std::size_t n, double spacing) {
  const double largest = scale.empty() ? 1 : *std::max_element(scale.begin(), scale.end());
  const auto range = [&](std::size_t i, std::size_t j) {
    return scale.empty() ? spacing : spacing * (scale[i] + scale[j]) / 2;
  };
  const Grid grid(points, spacing * largest);
  std::vector<double> weight(points.size(), 0);
  std::priority_queue<std::pair<double, std::size_t>> queue;
  for (std::size_t i = kept; i < points.size(); ++i) {
    grid.neighbours(i, [&](std::size_t j, double d) { weight[i] += crowding(d, range(i, j)); });
    queue.push({weight[i], i});
  }
  std::vector<bool> removed(points.size());
  for (std::size_t left = points.size(); left > std::max(n, kept);) {
    const auto [w, i] = queue.top();
    queue.pop();
    if (w != weight[i]) {  // outdated: weights only fall, so each point needs one entry
      queue.push({weight[i], i});
      continue;
    }
    removed[i] = true;
    --left;
    const std::size_t gone = i;
    grid.neighbours(gone, [&](std::size_t j, double d) {
      if (j >= kept && !removed[j]) weight[j] -= crowding(d, range(gone, j));
    });
  }
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!removed[i]) result.push_back(i);
  return result;
}

}  // namespace arris::truth
