// Lines, fields and numbers of text, independent of the locale and without copying.
#pragma once

#include <cstdint>
#include <string_view>

#include "io/source.h"

namespace arris {

// Walks the lines of a text. Lines end in LF, CR LF or CR, whichever the first line ends in (CR LF
// counts as LF, and a CR before it is dropped).
class LineScanner {
 public:
  explicit LineScanner(std::string_view text) noexcept;

  // Moves to the next line; false at the end of the text.
  bool next() noexcept;
  // Moves to the next line that is not blank.
  bool next_filled() noexcept;
  // Moves to the next line that is neither blank nor a comment, and cuts off the comment at its
  // end, if any. Comments start with '#'.
  bool next_content() noexcept;

  std::string_view line() const noexcept { return line_; }
  std::size_t number() const noexcept { return number_; }  // from 1
  std::size_t offset() const noexcept { return offset_; }  // of the first byte after the line
  std::size_t remaining() const noexcept { return text_.size() - offset_; }
  // Share of the text behind, in [0, 1].
  double fraction() const noexcept;
  // The number of lines to come.
  std::uint64_t count_remaining() const noexcept;

 private:
  std::string_view text_, line_;
  std::size_t offset_ = 0, number_ = 0;
  char end_ = '\n';
};

bool is_blank(char c) noexcept;
std::string_view trimmed(std::string_view text) noexcept;
std::string lower_case(std::string_view text);
// Takes the next run of non-blank characters off the front of `rest`; empty if there is none.
std::string_view next_field(std::string_view& rest) noexcept;

// Reads all of `text` as the nearest double; "nan" and "inf" in any case, a leading '+' allowed,
// too large gives infinity, too small zero. False, and no change, if it is not a number.
bool parse_number(std::string_view text, double& value) noexcept;
// Reads all of `text` as a number, or throws unreadable at `where`.
double need_number(const Source& source, const std::string& where, std::string_view text);
// Reads a count: a whole number in [0, 2^64). Throws unreadable at `where`.
std::uint64_t need_count(const Source& source, const std::string& where, std::string_view text);

}  // namespace arris
