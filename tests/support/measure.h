// The measurements of bench/truth, under the names of the tests.
#pragma once

#include "truth/measure.h"

namespace arris::test {
using namespace truth;
}  // namespace arris::test
