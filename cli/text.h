// Numbers as people write them.
#pragma once

#include <cstdint>
#include <string>

namespace arris::cli {

std::string with_commas(std::uint64_t number);               // 1234567 -> "1,234,567"
std::string counted(std::uint64_t number, const char* one);  // 2, "face" -> "2 faces"
std::string human_bytes(std::uint64_t bytes);                // 3670016 -> "3.5 MiB"
std::string human_seconds(double seconds);                   // 0.25 -> "0.25 s", 75 -> "1:15 min"
std::string short_number(double value);                      // up to 6 significant digits
std::string exact_number(double value);                      // shortest text that reads back equal
std::string quoted(const std::string& text);                 // in single quotes, for messages

}  // namespace arris::cli
