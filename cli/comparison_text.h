// What arris compare prints.
#pragma once

#include <string>

#include "compare/compare.h"

namespace arris::cli {

// A table for people, to standard output.
void print_comparison(const std::string& result, const std::string& truth,
                      const compare::Comparison& comparison);

}  // namespace arris::cli
