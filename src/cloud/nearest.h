// The nearest samples to any point, by a tree of boxes along the Morton curve: Karras, "Maximizing
// parallelism in the construction of BVHs, octrees, and k-d trees" (2012).
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "arris/types.h"

namespace arris {

// Of `points`, not empty, finite. Building: O(n) if they come along the Morton curve
// (cloud/morton.h), as samples do, else O(n log n). 48 bytes a point.
class NearestSample {
 public:
  explicit NearestSample(const std::vector<Vec3>& points);
  ~NearestSample();
  NearestSample(const NearestSample&) = delete;
  NearestSample& operator=(const NearestSample&) = delete;

  struct Hit {
    Index index = no_index;
    double distance = 0;
  };
  // The lowest index of equally near ones. O(log n). Safe to call from several threads.
  Hit operator()(Vec3 query) const;
  // The k nearest (all, if there are fewer), nearest first; equally near ones by index. O(k log n).
  void nearest(Vec3 query, std::size_t k, std::vector<Hit>& hits) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace arris
