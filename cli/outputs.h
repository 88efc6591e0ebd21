// Outputs are examined before the long work starts, so that it is not done in vain.
#pragma once

#include <string>
#include <vector>

#include "arris/error.h"

namespace arris::cli {

struct Output {
  std::string what;                     // "the mesh", for messages
  std::string path;                     // empty: not asked for
  std::vector<std::string> extensions;  // lower case with the dot; empty: any
};

// Refuses (usage) an output that is the input or another output, (unsupported) an extension that is
// not one of Output::extensions, (unwritable) a path that is a directory or closed to writing, or
// whose directory is missing or closed.
Result<void> check_outputs(const std::string& input, const std::vector<Output>& outputs);

}  // namespace arris::cli
