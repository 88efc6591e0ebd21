// The two bodies of a PLY file, binary and ascii, behind one set of calls:
//
//   body.begin_row(element, row);
//   body.coordinate(type); body.scalar(type); body.skip(type, body.list_size(count_type));
//   body.end_row();
//
// Every call throws unreadable, naming the element and the row, if the file does not hold it.
#pragma once

#include <bit>
#include <cstring>
#include <string>

#include "io/ply_format.h"
#include "io/text_scan.h"

namespace arris {

// "vertex 812 of 1000".
std::string ply_row(const PlyElement& element, std::uint64_t row);

class BinaryBody {
 public:
  BinaryBody(const Source& source, const PlyHeader& header)
      : source_(source),
        bytes_(header.body),
        swap_((header.format == PlyFormat::big_endian) !=
              (std::endian::native == std::endian::big)) {}

  // Throws if the file is too short for the declared count: nothing is allocated before that.
  void require(const PlyElement& element) const;
  // Passes over the whole element.
  void skip_element(const PlyElement& element);

  void begin_row(const PlyElement& element, std::uint64_t row) noexcept {
    element_ = &element;
    row_ = row;
  }
  void end_row() const noexcept {}
  double scalar(ScalarType type);
  double coordinate(ScalarType type) { return scalar(type); }
  std::uint64_t list_size(ScalarType type);
  void skip(ScalarType type, std::uint64_t count) { take(count * bytes_of(type)); }

  std::string where() const { return ply_row(*element_, row_); }
  std::size_t line() const noexcept { return 0; }
  std::size_t remaining() const noexcept { return bytes_.size() - offset_; }
  std::size_t row_remaining() const noexcept { return remaining(); }
  bool has_more() const noexcept { return remaining() > 0; }
  double fraction() const noexcept {
    return static_cast<double>(offset_) / static_cast<double>(bytes_.size() + 1);
  }

 private:
  const char* take(std::uint64_t count);
  template <class T>
  T load();

  const Source& source_;
  std::string_view bytes_;
  std::size_t offset_ = 0;
  bool swap_;
  const PlyElement* element_ = nullptr;
  std::uint64_t row_ = 0;
};

// One instance of an element per line; blank lines are passed over.
class AsciiBody {
 public:
  AsciiBody(const Source& source, const PlyHeader& header)
      : source_(source), lines_(header.body), header_lines_(header.lines) {}

  void require(const PlyElement& element) const;
  void skip_element(const PlyElement& element);

  void begin_row(const PlyElement& element, std::uint64_t row);
  void end_row() const;
  // A value exactly as a variable of the declared type would hold it.
  double scalar(ScalarType type);
  // Keeps all digits of the text, whatever the declared type.
  double coordinate(ScalarType type);
  std::uint64_t list_size(ScalarType type);
  void skip(ScalarType type, std::uint64_t count);

  std::string where() const;
  std::size_t line() const noexcept { return header_lines_ + lines_.number(); }
  std::size_t remaining() const noexcept { return lines_.remaining(); }
  std::size_t row_remaining() const noexcept { return rest_.size(); }
  bool has_more() noexcept { return lines_.next_filled(); }
  double fraction() const noexcept { return lines_.fraction(); }

 private:
  std::string_view field();

  const Source& source_;
  LineScanner lines_;
  std::size_t header_lines_;
  std::string_view rest_;
  const PlyElement* element_ = nullptr;
  std::uint64_t row_ = 0;
};

}  // namespace arris
