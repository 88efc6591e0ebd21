// The nearest samples to any point, by a k-d tree (nanoflann, hidden in nearest.cpp).
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "arris/types.h"

namespace arris {

// Keeps a reference to `points`, which must outlive it and not be empty. Building: O(n log n).
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
  // O(log n). Safe to call from several threads.
  Hit operator()(Vec3 query) const;
  // The k nearest (all, if there are fewer), nearest first; equally near ones by index. O(k log n).
  void nearest(Vec3 query, std::size_t k, std::vector<Hit>& hits) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace arris
