// A count of defects of one kind with one example of it.
#pragma once

#include <array>
#include <cstdint>

#include "arris/types.h"

namespace arris {

// `example` holds the indices of the elements of one defect; what they are depends on the kind.
struct Defects {
  std::uint64_t count = 0;
  std::array<Index, 3> example{no_index, no_index, no_index};

  // Keeps the first example.
  void add(Index a, Index b = no_index, Index c = no_index) {
    if (count++ == 0) example = {a, b, c};
  }
  // Adds the defects of a later part of the mesh.
  void append(const Defects& later) {
    if (count == 0) example = later.example;
    count += later.count;
  }
};

}  // namespace arris
