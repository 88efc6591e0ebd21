// Numbers as text: the shortest digits that read back as the same value, whatever the locale.
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>

namespace arris {

// Enough for any double ("-1.7976931348623157e+308") and any 64-bit integer.
using NumberBuffer = std::array<char, 32>;

// Number is double, float or an integer. The view points into `buffer`.
template <class Number>
std::string_view format_number(Number value, NumberBuffer& buffer) noexcept {
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), static_cast<std::size_t>(result.ptr - buffer.data())};
}

template <class Number>
std::string format_number(Number value) {
  NumberBuffer buffer;
  return std::string(format_number(value, buffer));
}

// For messages: whole numbers in full ("2000000000", where the shortest digits are "2e+09").
inline std::string readable(double value) {
  constexpr double exact = 1e15;  // up to here every whole number is a double
  if (value > -exact && value < exact &&
      value == static_cast<double>(static_cast<long long>(value)))
    return format_number(static_cast<long long>(value));
  return format_number(value);
}

}  // namespace arris
