// The version of the library, as text. Follows semantic versioning; 0.x may change the API.
#pragma once

#define ARRIS_VERSION_MAJOR 0
#define ARRIS_VERSION_MINOR 1
#define ARRIS_VERSION_PATCH 0
#define ARRIS_VERSION "0.1.0"

namespace arris {

// The version the library was built as; compare with ARRIS_VERSION of the headers.
const char* version() noexcept;

}  // namespace arris
