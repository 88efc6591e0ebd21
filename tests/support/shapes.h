// The solids of bench/truth, under the names of the tests.
#pragma once

#include "truth/shapes.h"

namespace arris::test {
using namespace truth;
}  // namespace arris::test
