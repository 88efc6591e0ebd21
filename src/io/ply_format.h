// The structure of PLY files, shared by the header parser and the two body readers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "arris/types.h"
#include "io/source.h"

namespace arris {

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::f32;
  bool is_list = false;
  ScalarType count_type = ScalarType::u8;  // of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool has_list() const noexcept;
  // Bytes of one instance in a binary file; without those in its lists.
  std::uint64_t binary_bytes() const noexcept;
};

enum class PlyFormat { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t lines = 0;  // of the header
  std::string_view body;  // the bytes after it
};

std::size_t bytes_of(ScalarType type) noexcept;
// The name that arris writes: "char", "uchar", ... "double".
const char* ply_name(ScalarType type) noexcept;

// Throws unreadable (with the line) or unsupported (a version other than 1.0).
PlyHeader parse_ply_header(const Source& source);

}  // namespace arris
