#include "io/text_scan.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>

namespace arris {
namespace {

bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}

// Whether the decimal number `text` (no sign, known to be out of the range of double) is huge
// rather than tiny: the sign of the decimal exponent of its first non-zero digit.
bool is_huge(std::string_view text) noexcept {
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  const std::string_view digits = text.substr(0, e);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::size_t first = std::min(digits.find_first_of("123456789"), digits.size());
  std::int64_t exponent = 0;
  if (e < text.size()) {
    std::string_view power = text.substr(e + 1);
    if (power.starts_with('+')) power.remove_prefix(1);
    const auto [end, error] = std::from_chars(power.data(), power.data() + power.size(), exponent);
    if (error == std::errc::result_out_of_range) return !power.starts_with('-');
  }
  return exponent > static_cast<std::int64_t>(first) - static_cast<std::int64_t>(point);
}

}  // namespace

LineScanner::LineScanner(std::string_view text) noexcept : text_(text) {
  const std::size_t first = text.find_first_of("\r\n");
  const bool carriage_return = first != text.npos && text[first] == '\r' &&
                               (first + 1 == text.size() || text[first + 1] != '\n');
  if (carriage_return) end_ = '\r';
}

bool LineScanner::next() noexcept {
  if (offset_ >= text_.size()) return false;
  const char* begin = text_.data() + offset_;
  const void* hit = std::memchr(begin, end_, remaining());
  const std::size_t length =
      hit ? static_cast<std::size_t>(static_cast<const char*>(hit) - begin) : remaining();
  line_ = text_.substr(offset_, length);
  offset_ += length + (hit ? 1 : 0);
  if (end_ == '\n' && line_.ends_with('\r')) line_.remove_suffix(1);
  ++number_;
  return true;
}

bool LineScanner::next_filled() noexcept {
  while (next())
    if (!trimmed(line_).empty()) return true;
  return false;
}

bool LineScanner::next_content() noexcept {
  while (next()) {
    line_ = trimmed(line_.substr(0, line_.find('#')));
    if (!line_.empty()) return true;
  }
  return false;
}

double LineScanner::fraction() const noexcept {
  return text_.empty() ? 1 : static_cast<double>(offset_) / static_cast<double>(text_.size());
}

std::uint64_t LineScanner::count_remaining() const noexcept {
  const std::string_view rest = text_.substr(offset_);
  const auto breaks = std::count(rest.begin(), rest.end(), end_);
  return static_cast<std::uint64_t>(breaks) + (rest.empty() || rest.back() == end_ ? 0 : 1);
}

bool is_blank(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

std::string_view trimmed(std::string_view text) noexcept {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

std::string_view next_field(std::string_view& rest) noexcept {
  std::size_t begin = 0;
  while (begin < rest.size() && is_blank(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_blank(rest[end])) ++end;
  const std::string_view field = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return field;
}

bool parse_number(std::string_view text, double& value) noexcept {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const char* end = text.data() + text.size();
  double parsed = 0;
  const auto [stop, error] = std::from_chars(text.data(), end, parsed);
  if (stop != end || error == std::errc::invalid_argument) return false;
  if (error == std::errc::result_out_of_range) {
    const bool negative = text[0] == '-';
    parsed = is_huge(text.substr(negative ? 1 : 0)) ? std::numeric_limits<double>::infinity() : 0;
    if (negative) parsed = -parsed;
  }
  value = parsed;
  return true;
}

double need_number(const Source& source, const std::string& where, std::string_view text) {
  double value = 0;
  if (!parse_number(text, value))
    malformed(source, where, quoted(text) + " is not a number",
              "correct that place; numbers are written like -1.5e3, with a decimal point");
  return value;
}

std::uint64_t need_count(const Source& source, const std::string& where, std::string_view text) {
  std::uint64_t count = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (stop == text.data() + text.size() && error == std::errc{}) return count;
  if (text.size() > 1 && text[0] == '-' && is_digit(text[1]))
    malformed(source, where, "negative count " + quoted(text));
  if (error == std::errc::result_out_of_range)
    malformed(source, where, "the count " + quoted(text) + " is absurdly large");
  malformed(source, where, quoted(text) + " is not a count");
}

}  // namespace arris
