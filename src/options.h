// Options as used: checked, with the defaults of the method filled in.
#pragma once

#include "arris/options.h"

namespace arris {

// Throws Failure(usage), naming the option, its value and its range.
Options resolve_options(Options options);

}  // namespace arris
