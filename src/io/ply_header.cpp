#include <algorithm>
#include <optional>

#include "io/ply_format.h"
#include "io/text_scan.h"

namespace arris {
namespace {

std::optional<ScalarType> type_named(std::string_view name) noexcept {
  struct Name {
    const char* text;
    ScalarType type;
  };
  static constexpr Name names[] = {
      {"char", ScalarType::i8},    {"int8", ScalarType::i8},     {"uchar", ScalarType::u8},
      {"uint8", ScalarType::u8},   {"short", ScalarType::i16},   {"int16", ScalarType::i16},
      {"ushort", ScalarType::u16}, {"uint16", ScalarType::u16},  {"int", ScalarType::i32},
      {"int32", ScalarType::i32},  {"uint", ScalarType::u32},    {"uint32", ScalarType::u32},
      {"float", ScalarType::f32},  {"float32", ScalarType::f32}, {"double", ScalarType::f64},
      {"float64", ScalarType::f64}};
  for (const Name& n : names)
    if (name == n.text) return n.type;
  return std::nullopt;
}

// Reads the header line by line into a PlyHeader.
class HeaderParser {
 public:
  explicit HeaderParser(const Source& source) : source_(source), lines_(source.bytes) {}

  PlyHeader parse() {
    if (!lines_.next() || trimmed(lines_.line()) != "ply")
      malformed(source_, at_line(1), "does not say 'ply', so this is not a PLY file",
                "give it the extension of its real format");
    while (true) {
      if (!lines_.next())
        malformed(source_, at_line(lines_.number()), "the file ends within the header",
                  remedy_incomplete);
      std::string_view rest = lines_.line();
      const std::string_view keyword = next_field(rest);
      if (keyword == "end_header") break;
      take(keyword, rest);
    }
    if (!have_format_) fail_here("the header has no format line");
    header_.lines = lines_.number();
    header_.body = source_.bytes.substr(lines_.offset());
    return std::move(header_);
  }

 private:
  void take(std::string_view keyword, std::string_view rest) {
    if (keyword == "format")
      take_format(rest);
    else if (keyword == "element")
      take_element(rest);
    else if (keyword == "property")
      take_property(rest);
    else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info")
      fail_here(quoted(keyword) + " is not a line of a PLY header");
  }

  void take_format(std::string_view rest) {
    const std::string_view format = next_field(rest), version = next_field(rest);
    if (format == "ascii")
      header_.format = PlyFormat::ascii;
    else if (format == "binary_little_endian")
      header_.format = PlyFormat::little_endian;
    else if (format == "binary_big_endian")
      header_.format = PlyFormat::big_endian;
    else
      fail_here(quoted(format) + " is not a PLY format");
    if (version != "1.0")
      fail(source_, ErrorCode::unsupported, at_line(lines_.number()),
           "PLY version " + quoted(version) + " is not 1.0", "export the file as PLY 1.0");
    have_format_ = true;
  }

  void take_element(std::string_view rest) {
    PlyElement element;
    element.name = next_field(rest);
    const std::string_view count = next_field(rest);
    if (element.name.empty() || count.empty()) fail_here("an element needs a name and a count");
    element.count = need_count(source_, at_line(lines_.number()), count);
    for (const PlyElement& other : header_.elements)
      if (other.name == element.name)
        fail_here("element " + quoted(element.name) + " is declared twice");
    header_.elements.push_back(std::move(element));
    if (header_.elements.size() > most_) fail_here("the header declares too many elements");
  }

  void take_property(std::string_view rest) {
    if (header_.elements.empty()) fail_here("a property comes before the first element");
    PlyProperty property;
    std::string_view type = next_field(rest);
    if (type == "list") {
      property.is_list = true;
      property.count_type = need_type(next_field(rest));
      type = next_field(rest);
    }
    property.type = need_type(type);
    property.name = next_field(rest);
    if (property.name.empty()) fail_here("the property has no name");
    auto& properties = header_.elements.back().properties;
    for (const PlyProperty& other : properties)
      if (other.name == property.name)
        fail_here("property " + quoted(property.name) + " is declared twice");
    properties.push_back(std::move(property));
    if (properties.size() > most_) fail_here("the element has too many properties");
  }

  ScalarType need_type(std::string_view name) const {
    const std::optional<ScalarType> type = type_named(name);
    if (!type) fail_here(quoted(name) + " is not a type of PLY");
    return *type;
  }

  [[noreturn]] void fail_here(const std::string& what) const {
    malformed(source_, at_line(lines_.number()), what);
  }

  static constexpr std::size_t most_ = 1024;  // elements, properties: more are garbage
  const Source& source_;
  LineScanner lines_;
  PlyHeader header_;
  bool have_format_ = false;
};

}  // namespace

bool PlyElement::has_list() const noexcept {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.is_list; });
}

std::uint64_t PlyElement::binary_bytes() const noexcept {
  std::uint64_t bytes = 0;
  for (const PlyProperty& p : properties) bytes += bytes_of(p.is_list ? p.count_type : p.type);
  return bytes;
}

std::size_t bytes_of(ScalarType type) noexcept {
  switch (type) {
    case ScalarType::i8:
    case ScalarType::u8:
      return 1;
    case ScalarType::i16:
    case ScalarType::u16:
      return 2;
    case ScalarType::i32:
    case ScalarType::u32:
    case ScalarType::f32:
      return 4;
    case ScalarType::f64:
      return 8;
  }
  return 8;
}

const char* ply_name(ScalarType type) noexcept {
  switch (type) {
    case ScalarType::i8:
      return "char";
    case ScalarType::u8:
      return "uchar";
    case ScalarType::i16:
      return "short";
    case ScalarType::u16:
      return "ushort";
    case ScalarType::i32:
      return "int";
    case ScalarType::u32:
      return "uint";
    case ScalarType::f32:
      return "float";
    case ScalarType::f64:
      return "double";
  }
  return "double";
}

PlyHeader parse_ply_header(const Source& source) {
  return HeaderParser(source).parse();
}

}  // namespace arris
