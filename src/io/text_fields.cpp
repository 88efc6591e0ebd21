#include "io/text_fields.h"

#include <algorithm>

#include "io/text_scan.h"

namespace arris {

Separator separator_of(std::string_view line) noexcept {
  if (line.find(';') != line.npos) return Separator::semicolon;
  if (line.find(',') != line.npos) return Separator::comma;
  return Separator::blank;
}

bool FieldSplitter::next(std::string_view& field) noexcept {
  if (separator_ == Separator::blank) {
    field = next_field(rest_);
    return !field.empty();
  }
  if (trimmed(rest_).empty()) return false;
  const std::size_t end = std::min(rest_.find(static_cast<char>(separator_)), rest_.size());
  field = trimmed(rest_.substr(0, end));
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  return true;
}

std::vector<std::string> parse_names(std::string_view line, Separator separator) {
  std::vector<std::string> names;
  FieldSplitter fields(line, separator);
  for (std::string_view field; fields.next(field);) {
    const bool in_quotes = field.size() > 1 && field.front() == '"' && field.back() == '"';
    names.emplace_back(in_quotes ? field.substr(1, field.size() - 2) : field);
    if (names.back().empty()) names.back() = column_name(names.size() - 1);
  }
  return names;
}

bool find_positions(const std::vector<std::string>& names, std::array<std::size_t, 3>& position) {
  std::array<std::size_t, 3> found{};
  for (std::size_t column = 0; column < names.size(); ++column) {
    const std::string name = lower_case(names[column]);
    if (name != "x" && name != "y" && name != "z") continue;
    const auto axis = static_cast<std::size_t>(name[0] - 'x');
    position[axis] = column;
    ++found[axis];
  }
  return found == std::array<std::size_t, 3>{1, 1, 1};
}

std::string column_name(std::size_t column) {
  std::string name = "c";
  return name.append(std::to_string(column));
}

Columns unnamed_columns(std::size_t count) {
  Columns columns;
  columns.names = {"x", "y", "z"};
  for (std::size_t k = 3; k < count; ++k) columns.names.push_back(column_name(k));
  return columns;
}

void name_by_count(std::vector<Attribute>& attributes, TextKind kind) {
  std::vector<const char*> names;
  if (attributes.size() == 3) {
    // Components of unit normals are at most 1, so whole numbers above that can only be colours.
    const auto bytes = [](const Attribute& a) { return are_bytes(a.values); };
    const auto above = [](const Attribute& a) { return any_above(a.values, 1); };
    const bool colours = std::all_of(attributes.begin(), attributes.end(), bytes) &&
                         std::any_of(attributes.begin(), attributes.end(), above);
    if (kind == TextKind::pts || colours)
      names = {"red", "green", "blue"};
    else
      names = {"nx", "ny", "nz"};
  } else if (kind == TextKind::pts && (attributes.size() == 1 || attributes.size() == 4)) {
    names = {"intensity", "red", "green", "blue"};
  }
  for (std::size_t k = 0; k < std::min(names.size(), attributes.size()); ++k)
    attributes[k].name = names[k];
}

void type_colours(std::vector<Attribute>& attributes) {
  static constexpr const char* colours[] = {"red", "green", "blue", "r", "g", "b"};
  for (Attribute& a : attributes)
    if (std::find(std::begin(colours), std::end(colours), lower_case(a.name)) !=
            std::end(colours) &&
        are_bytes(a.values))
      a.type = ScalarType::u8;
}

bool are_bytes(const std::vector<double>& values) noexcept {
  return std::all_of(values.begin(), values.end(), [](double v) {
    return v >= 0 && v <= 255 && v == static_cast<double>(static_cast<int>(v));
  });
}

bool any_above(const std::vector<double>& values, double bound) noexcept {
  return std::any_of(values.begin(), values.end(), [=](double v) { return v > bound; });
}

}  // namespace arris
