// Points as text, one per line: .xyz .txt .asc .csv .pts.
#include <algorithm>
#include <limits>
#include <optional>

#include "io/readers.h"
#include "io/text_fields.h"
#include "io/text_scan.h"

namespace arris {
namespace {

constexpr std::size_t lines_between_ticks = 4096;
constexpr std::size_t most_columns = 1024;  // more are garbage

bool is_comment(std::string_view line) {
  return line.starts_with('#') || line.starts_with("//");
}

class TextReader {
 public:
  TextReader(const Source& source, TextKind kind)
      : source_(source), kind_(kind), lines_(without_mark(source.bytes)) {}

  Shape read() {
    require_text(source_);
    while (lines_.next()) {
      if (lines_.number() % lines_between_ticks == 0) source_.job.tick(lines_.fraction());
      const std::string_view line = trimmed(lines_.line());
      if (line.empty()) continue;
      if (is_comment(line))
        comment_ = line;
      else if (!take_count(line) && (columns_.names.empty() ? start(line) : true))
        take_point(line);
    }
    if (declared_ && *declared_ != shape_.positions.size()) fail_count();
    if (!named_) name_by_count(shape_.attributes, kind_);
    type_colours(shape_.attributes);
    return std::move(shape_);
  }

 private:
  // The text without the byte order mark that some editors put before UTF-8.
  static std::string_view without_mark(std::string_view text) {
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
  }

  // A line of one whole number in .pts declares how many points follow.
  bool take_count(std::string_view line) {
    if (kind_ != TextKind::pts || line.find_first_not_of("0123456789") != line.npos) return false;
    const std::uint64_t count = need_count(source_, at_line(lines_.number()), line);
    constexpr std::uint64_t shortest = 6;  // bytes of a point: "0 0 0\n"
    if (count > (lines_.remaining() + 1) / shortest)
      malformed(source_, at_line(lines_.number()),
                "file ends early, " + std::to_string(count) + " points are declared and at most " +
                    std::to_string((lines_.remaining() + 1) / shortest) + " fit",
                remedy_incomplete);
    declared_ = declared_.value_or(0) + count;
    return true;
  }

  // Settles the columns by the first line. True if it holds a point, false if it holds names.
  bool start(std::string_view line) {
    separator_ = separator_of(line);
    const std::vector<std::string> fields = parse_names(line, separator_);
    double ignored = 0;
    const bool numbers = std::any_of(fields.begin(), fields.end(), [&](const std::string& f) {
      return parse_number(f, ignored);
    });
    if (fields.size() < 3 || fields.size() > most_columns)
      malformed(source_, at_line(lines_.number()),
                "has " + std::to_string(fields.size()) + " columns where x, y and z are needed" +
                    (fields.size() == 1 ? ": " + quoted(line) : ""),
                "write one point per line, its numbers separated by blanks, commas or semicolons");
    if (numbers)
      columns_ = columns_from_comment(fields.size());
    else
      columns_ = columns_named(fields);
    add_attributes();
    return numbers;
  }

  Columns columns_named(const std::vector<std::string>& names) {
    Columns columns;
    columns.names = names;
    if (!find_positions(names, columns.position))
      malformed(source_, at_line(lines_.number()),
                "names the columns, but not one x, one y and one z",
                "name the columns x, y and z, or remove the line of names");
    std::vector<std::string> sorted = names;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
      malformed(source_, at_line(lines_.number()), "names column " + quoted(*twice) + " twice",
                "give every column a name of its own");
    named_ = true;
    return columns;
  }

  // Some programs write the names as a comment before the first point ("//X Y Z R G B").
  Columns columns_from_comment(std::size_t count) {
    std::string_view text = comment_;
    text.remove_prefix(std::min(text.find_first_not_of("#/"), text.size()));
    Columns columns;
    columns.names = parse_names(text, separator_of(text));
    if (columns.names.size() != count || !find_positions(columns.names, columns.position))
      return unnamed_columns(count);
    named_ = true;
    return columns;
  }

  void add_attributes() {
    const std::size_t columns = columns_.names.size();
    const std::uint64_t rows =
        std::min<std::uint64_t>(lines_.count_remaining() + 1, source_.bytes.size() / columns + 1);
    require_memory(source_, "points", rows, sizeof(double) * columns);
    const auto& xyz = columns_.position;
    for (std::size_t k = 0; k < columns; ++k) {
      if (std::find(xyz.begin(), xyz.end(), k) != xyz.end()) continue;
      attribute_columns_.push_back(k);
      shape_.attributes.push_back({columns_.names[k], ScalarType::f64, {}});
      shape_.attributes.back().values.reserve(rows);
    }
    shape_.positions.reserve(rows);
    row_.resize(columns);
  }

  void take_point(std::string_view line) {
    FieldSplitter fields(line, separator_);
    std::size_t count = 0;
    for (std::string_view field; fields.next(field); ++count)
      if (count < row_.size()) row_[count] = number(field, count);
    if (count != row_.size())
      malformed(source_, at_line(lines_.number()),
                "has " + std::to_string(count) + " columns where the lines before have " +
                    std::to_string(row_.size()));
    require_indexable(source_, shape_.positions.size() + 1);
    const auto& xyz = columns_.position;
    shape_.positions.push_back({row_[xyz[0]], row_[xyz[1]], row_[xyz[2]]});
    for (std::size_t k = 0; k < attribute_columns_.size(); ++k)
      shape_.attributes[k].values.push_back(row_[attribute_columns_[k]]);
  }

  // An empty field is a missing value: none for an attribute, an error for a coordinate.
  double number(std::string_view field, std::size_t column) const {
    double value = std::numeric_limits<double>::quiet_NaN();
    if (parse_number(field, value)) return value;
    const auto& xyz = columns_.position;
    if (field.empty() && std::find(xyz.begin(), xyz.end(), column) == xyz.end()) return value;
    return need_number(source_, at_line(lines_.number()) + ", column " + std::to_string(column + 1),
                       field);
  }

  [[noreturn]] void fail_count() const {
    malformed(source_, at_line(lines_.number()),
              "the file has " + std::to_string(shape_.positions.size()) + " points, but declares " +
                  std::to_string(*declared_),
              remedy_incomplete);
  }

  const Source& source_;
  TextKind kind_;
  LineScanner lines_;
  std::string_view comment_;  // the last one before the first point
  Separator separator_ = Separator::blank;
  Columns columns_;
  bool named_ = false;
  std::vector<std::size_t> attribute_columns_;
  std::vector<double> row_;
  std::optional<std::uint64_t> declared_;  // points, by count lines
  Shape shape_;
};

}  // namespace

Shape read_text(const Source& source, TextKind kind) {
  return TextReader(source, kind).read();
}

}  // namespace arris
