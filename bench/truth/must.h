// For solids whose parts are ours: that they combine is a promise of this directory.
#pragma once

#include <optional>
#include <stdexcept>
#include <utility>

#include "arris/types.h"

namespace arris::truth {

inline Mesh must(std::optional<Mesh> mesh) {
  if (!mesh) throw std::logic_error("the parts of a model do not combine");
  return *std::move(mesh);
}

}  // namespace arris::truth
