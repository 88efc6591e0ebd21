#include "values.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace arris::cli {
namespace {

template <class Number>
std::optional<Number> parse(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string must_be(const std::string& what, const std::string& text) {
  return "must be " + what + ", not " + quoted(text);
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  return parse<double>(text);
}

CLI::Validator number_in(double low, double high, const char* description) {
  const std::string what = description;
  const auto check = [low, high, what](const std::string& text) -> std::string {
    const std::optional<double> value = parse_number(text);
    // Written so that NaN fails.
    const bool good = value && std::isfinite(*value) && *value >= low && *value <= high;
    return good ? std::string() : must_be(what, text);
  };
  return CLI::Validator(check, "", "number");
}

CLI::Validator whole_number_in(long long low, long long high, const char* description) {
  const std::string what = description;
  const auto check = [low, high, what](const std::string& text) -> std::string {
    const std::optional<long long> value = parse<long long>(text);
    return value && *value >= low && *value <= high ? std::string() : must_be(what, text);
  };
  return CLI::Validator(check, "", "whole number");
}

CLI::Validator not_empty() {
  const auto check = [](const std::string& text) -> std::string {
    return text.empty() ? "must name a file" : "";
  };
  return CLI::Validator(check, "", "file name");
}

std::size_t parse_bytes(const std::string& text) {
  const std::string error = must_be("a size such as 4G, 512M or 1000000", text);
  const std::size_t digits = std::min(text.find_first_not_of("0123456789."), text.size());
  const std::optional<double> number = parse_number(std::string_view(text).substr(0, digits));
  std::string unit;
  for (const char c : text.substr(digits))
    if (c != ' ') unit += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (unit.ends_with("IB")) unit.resize(unit.size() - 2);
  if (unit.ends_with("B")) unit.resize(unit.size() - 1);
  const std::size_t power = unit.empty() ? 0 : std::string("KMGT").find(unit) + 1;
  if (!number || unit.size() > 1 || power > 4 || (power == 0 && !unit.empty()))
    throw CLI::ValidationError("--memory-limit", error);
  const double bytes = std::ldexp(*number, static_cast<int>(10 * power));
  // The largest double below 2^64, which a size_t can hold.
  if (!(bytes >= 1) || bytes >= static_cast<double>(std::numeric_limits<std::size_t>::max()))
    throw CLI::ValidationError("--memory-limit", error);
  return static_cast<std::size_t>(bytes);
}

}  // namespace arris::cli
