// The columns of delimited text: how its lines are cut into fields, and what they are called.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "arris/types.h"
#include "io/readers.h"

namespace arris {

// What separates fields: a semicolon or a comma if the line has one, otherwise runs of blanks.
enum class Separator : char { blank = ' ', comma = ',', semicolon = ';' };
Separator separator_of(std::string_view line) noexcept;

// Cuts a line into fields without blanks around them. Between commas or semicolons a field may be
// empty, but one after the last of them does not count.
class FieldSplitter {
 public:
  FieldSplitter(std::string_view line, Separator separator) noexcept
      : rest_(line), separator_(separator) {}
  // False when there are no more fields.
  bool next(std::string_view& field) noexcept;

 private:
  std::string_view rest_;
  Separator separator_;
};

// What each column holds.
struct Columns {
  std::array<std::size_t, 3> position{0, 1, 2};
  std::vector<std::string> names;  // one for each column
};

// The names in a header line, without quotation marks.
std::vector<std::string> parse_names(std::string_view line, Separator separator);
// Finds columns x, y and z in any letter case; false if one is missing or there twice.
bool find_positions(const std::vector<std::string>& names, std::array<std::size_t, 3>& position);
// "c7": the name of column 7 (from 0) of a file that names it not.
std::string column_name(std::size_t column);
// x, y, z, then c3, c4, ... for a file that names nothing.
Columns unnamed_columns(std::size_t count);

// Names the further columns of a file without names as their number makes clear: intensity and
// colours of .pts, normals or colours in six columns.
void name_by_count(std::vector<Attribute>& attributes, TextKind kind);
// Colour columns that hold whole numbers of 0 to 255 alone get the type u8.
void type_colours(std::vector<Attribute>& attributes);

// Whether all values are whole numbers of 0 to 255.
bool are_bytes(const std::vector<double>& values) noexcept;
// Whether some value is above `bound`.
bool any_above(const std::vector<double>& values, double bound) noexcept;

}  // namespace arris
