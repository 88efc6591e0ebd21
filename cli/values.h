// Checks of option values that name the range, before any file is touched.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>

namespace arris::cli {

// A finite number in [low, high]; the description appears in messages and in the help.
CLI::Validator number_in(double low, double high, const char* description);

// A whole number in [low, high].
CLI::Validator whole_number_in(long long low, long long high, const char* description);

// Text that is not empty, for file names.
CLI::Validator not_empty();

// "4G", "1.5 GiB", "512M", "1000000": bytes; K, M, G, T are powers of 1024. Throws
// CLI::ValidationError for anything else, and for 0.
std::size_t parse_bytes(const std::string& text);

}  // namespace arris::cli
