// The surfaces of revolution of bench/truth, under the names of the tests.
#pragma once

#include "truth/revolution.h"

namespace arris::test {
using namespace truth;
}  // namespace arris::test
