#include "text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace arris::cli {
namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), pattern, values...);
  return buffer.data();
}

}  // namespace

std::string with_commas(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, 1, ',');
  return digits;
}

std::string counted(std::uint64_t number, const char* one) {
  const std::string noun = one;
  if (number == 1) return "1 " + noun;
  const bool x_to_ces = noun.size() > 2 && noun.ends_with("ex");  // vertex, vertices
  const char* const ending = noun.ends_with("ch") ? "es" : "s";   // patch, patches
  return with_commas(number) + " " +
         (x_to_ces ? noun.substr(0, noun.size() - 2) + "ices" : noun + ending);
}

std::string human_bytes(std::uint64_t bytes) {
  static constexpr std::array<const char*, 5> units = {"bytes", "KiB", "MiB", "GiB", "TiB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; value >= 1024 && unit + 1 < units.size(); ++unit) value /= 1024;
  return format(unit == 0 || value >= 100 ? "%.0f %s" : "%.1f %s", value, units.at(unit));
}

std::string human_seconds(double seconds) {
  if (seconds < 60) return format(seconds < 10 ? "%.2f s" : "%.1f s", seconds);
  const auto whole = static_cast<long long>(std::lround(seconds));
  if (whole < 3600) return format("%lld:%02lld min", whole / 60, whole % 60);
  return format("%lld:%02lld h", whole / 3600, whole % 3600 / 60);
}

std::string short_number(double value) {
  return format("%.6g", value);
}

std::string exact_number(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string quoted(const std::string& text) {
  std::string out(1, '\'');
  return out.append(text).append("'");
}

}  // namespace arris::cli
