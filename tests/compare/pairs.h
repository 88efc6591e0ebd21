// Pairs of small meshes made by code, of which figures by an independent evaluator are known.
#pragma once

#include <string>
#include <vector>

#include "arris/types.h"

namespace arris::test {

struct Pair {
  std::string name;
  Mesh result, truth;
};

std::vector<Pair> comparison_pairs();

}  // namespace arris::test
