// Lists as sets.
#pragma once

#include <algorithm>
#include <vector>

namespace arris {

// Sorts the list and leaves one of each. O(n log n).
template <class T>
void keep_distinct(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace arris
