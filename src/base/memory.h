// Memory given back before the end of its owner.
#pragma once

#include <vector>

namespace arris {

// Empties a vector and frees its room, which `v = {}` keeps.
template <class T>
void release(std::vector<T>& v) noexcept {
  std::vector<T>().swap(v);
}

// Gives back what has been freed, whichever thread it was allocated on: the C library keeps small
// pieces, and what lies beneath them, for later ones. Before work that needs large pieces. Takes
// milliseconds for each gigabyte. Does nothing where the C library is not glibc.
void return_free_memory() noexcept;

}  // namespace arris
