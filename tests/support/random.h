// The random generator of bench/truth, under the names of the tests.
#pragma once

#include "truth/random.h"

namespace arris::test {
using namespace truth;
}  // namespace arris::test
