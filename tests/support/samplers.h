// The samplers of bench/truth, under the names of the tests.
#pragma once

#include "truth/cloud.h"
#include "truth/samplers.h"

namespace arris::test {
using namespace truth;
}  // namespace arris::test
