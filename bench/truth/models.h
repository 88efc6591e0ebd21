// Every model by its name: the examples of the paper, more solids, and the random ones.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "arris/types.h"

namespace arris::truth {

struct ModelEntry {
  const char* name;
  const char* summary;
  // Segments round a full circle; flat models ignore it.
  Mesh (*make)(int resolution);
};

inline constexpr int default_resolution = 192;
inline constexpr int lowest_resolution = 24, highest_resolution = 1024;

// All models that need no seed, those of the paper first, as the paper orders them.
const std::vector<ModelEntry>& models();

// The model of that name: closed, manifold, free of intersections, oriented outwards (towards the
// void in a cavity), in its own unit. Throws std::out_of_range if there is none, and
// std::invalid_argument if the resolution is out of range.
Mesh make_model(std::string_view name, int resolution = default_resolution);

// The mesh moved and scaled so that its bounding box is centred at 0 and has diagonal 1.
Mesh to_unit_diagonal(Mesh mesh);

}  // namespace arris::truth
