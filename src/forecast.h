// How much memory a reconstruction will need, and whether it may have it.
#pragma once

#include "arris/context.h"
#include "arris/options.h"

namespace arris {

// Throws Failure(out_of_memory) if the forecast exceeds the limit of the context or the memory of
// the machine.
void require_memory(std::size_t points, const Options& options, const Context& context);

}  // namespace arris
