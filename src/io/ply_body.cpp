#include "io/ply_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/format_number.h"

namespace arris {
namespace {

constexpr std::size_t rows_between_ticks = 4096;

// A list count as read: whole, not negative, and no more than the bytes left.
template <class Body>
std::uint64_t checked_list_size(const Body& body, const Source& source, double count) {
  if (!(count >= 0) || count != std::floor(count))
    malformed(source, body.where(), "has a list with a negative or broken count");
  if (count > static_cast<double>(body.row_remaining()))
    malformed(source, body.where(),
              "has a list of " + readable(count) + " entries, more than the file holds",
              remedy_incomplete);
  return static_cast<std::uint64_t>(count);
}

// Passes over an element row by row, one property after the other.
template <class Body>
void skip_rows(Body& body, const PlyElement& element, Job& job) {
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (row % rows_between_ticks == 0) job.tick(body.fraction());
    body.begin_row(element, row);
    for (const PlyProperty& p : element.properties)
      body.skip(p.type, p.is_list ? body.list_size(p.count_type) : 1);
  }
}

template <class T>
bool fits(double value) noexcept {
  return value >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
         value <= static_cast<double>(std::numeric_limits<T>::max()) && value == std::floor(value);
}

bool fits_integer(double value, ScalarType type) noexcept {
  switch (type) {
    case ScalarType::i8:
      return fits<std::int8_t>(value);
    case ScalarType::u8:
      return fits<std::uint8_t>(value);
    case ScalarType::i16:
      return fits<std::int16_t>(value);
    case ScalarType::u16:
      return fits<std::uint16_t>(value);
    case ScalarType::i32:
      return fits<std::int32_t>(value);
    case ScalarType::u32:
      return fits<std::uint32_t>(value);
    case ScalarType::f32:
    case ScalarType::f64:
      return true;
  }
  return true;
}

// The nearest float, where values beyond its range are infinite (a plain cast leaves that open).
double as_float(double value) noexcept {
  constexpr double greatest = std::numeric_limits<float>::max();
  constexpr double halfway = 0x1.ffffffp+127;  // from here on, rounding goes to infinity
  if (std::isfinite(value) && std::fabs(value) > greatest)
    return std::copysign(
        std::fabs(value) < halfway ? greatest : std::numeric_limits<double>::infinity(), value);
  return static_cast<double>(static_cast<float>(value));
}

}  // namespace

std::string ply_row(const PlyElement& element, std::uint64_t row) {
  return element.name + " " + std::to_string(row) + " of " + std::to_string(element.count);
}

void BinaryBody::require(const PlyElement& element) const {
  const std::uint64_t each = element.binary_bytes();
  if (each == 0 || element.count <= remaining() / each) return;
  const std::uint64_t room = remaining() / each;
  const std::string where = element.has_list() ? "element " + element.name : ply_row(element, room);
  malformed(source_, where,
            element.has_list() ? "file ends early, " + std::to_string(element.count) +
                                     " are declared and at most " + std::to_string(room) + " fit"
                               : "file ends early",
            remedy_incomplete);
}

void BinaryBody::skip_element(const PlyElement& element) {
  if (element.properties.empty()) return;
  require(element);
  if (element.has_list())
    skip_rows(*this, element, source_.job);
  else
    offset_ += element.count * element.binary_bytes();
}

double BinaryBody::scalar(ScalarType type) {
  switch (type) {
    case ScalarType::i8:
      return static_cast<double>(load<std::int8_t>());
    case ScalarType::u8:
      return static_cast<double>(load<std::uint8_t>());
    case ScalarType::i16:
      return static_cast<double>(load<std::int16_t>());
    case ScalarType::u16:
      return static_cast<double>(load<std::uint16_t>());
    case ScalarType::i32:
      return static_cast<double>(load<std::int32_t>());
    case ScalarType::u32:
      return static_cast<double>(load<std::uint32_t>());
    case ScalarType::f32:
      return static_cast<double>(load<float>());
    case ScalarType::f64:
      return load<double>();
  }
  return 0;
}

std::uint64_t BinaryBody::list_size(ScalarType type) {
  const double count = scalar(type);
  return checked_list_size(*this, source_, count);
}

const char* BinaryBody::take(std::uint64_t count) {
  if (count > remaining()) malformed(source_, where(), "file ends early", remedy_incomplete);
  const char* begin = bytes_.data() + offset_;
  offset_ += count;
  return begin;
}

template <class T>
T BinaryBody::load() {
  char bytes[sizeof(T)];
  std::memcpy(bytes, take(sizeof(T)), sizeof(T));
  if (swap_) std::reverse(bytes, bytes + sizeof(T));
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

void AsciiBody::require(const PlyElement& element) const {
  // A value takes a digit and a separator, save that the last one of the file needs none.
  const std::uint64_t each = 2 * element.properties.size();
  const std::uint64_t room = each ? (remaining() + 1) / each : 0;
  if (each == 0 || element.count <= room) return;
  malformed(source_, "element " + element.name,
            "file ends early, " + std::to_string(element.count) + " are declared and at most " +
                std::to_string(room) + " fit",
            remedy_incomplete);
}

void AsciiBody::skip_element(const PlyElement& element) {
  if (element.properties.empty()) return;
  require(element);
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (row % rows_between_ticks == 0) source_.job.tick(fraction());
    begin_row(element, row);
  }
}

void AsciiBody::begin_row(const PlyElement& element, std::uint64_t row) {
  element_ = &element;
  row_ = row;
  if (!lines_.next_filled())
    malformed(source_, ply_row(element, row), "file ends early", remedy_incomplete);
  rest_ = lines_.line();
}

void AsciiBody::end_row() const {
  std::string_view rest = rest_;
  const std::string_view extra = next_field(rest);
  if (!extra.empty())
    malformed(source_, where(), quoted(extra) + " comes after all declared properties");
}

double AsciiBody::scalar(ScalarType type) {
  const std::string_view text = field();
  double value = 0;
  if (!parse_number(text, value)) need_number(source_, where(), text);
  if (!fits_integer(value, type))
    malformed(source_, where(), quoted(text) + " does not fit the type " + ply_name(type));
  return type == ScalarType::f32 ? as_float(value) : value;
}

double AsciiBody::coordinate(ScalarType) {
  double value = 0;
  const std::string_view text = field();
  return parse_number(text, value) ? value : need_number(source_, where(), text);
}

std::uint64_t AsciiBody::list_size(ScalarType type) {
  const double count = scalar(type);
  return checked_list_size(*this, source_, count);
}

void AsciiBody::skip(ScalarType, std::uint64_t count) {
  for (std::uint64_t k = 0; k < count; ++k) field();
}

std::string AsciiBody::where() const {
  return at_line(line()) + ", " + ply_row(*element_, row_);
}

std::string_view AsciiBody::field() {
  const std::string_view text = next_field(rest_);
  if (!text.empty()) return text;
  // A short last line is a file cut off; elsewhere the line itself is at fault.
  if (remaining() == 0) malformed(source_, where(), "file ends early", remedy_incomplete);
  malformed(source_, where(), "has fewer values than declared");
}

}  // namespace arris
