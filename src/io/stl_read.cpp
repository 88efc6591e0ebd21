// STL, binary and ascii. Corners with identical coordinates become one vertex.
#include <bit>
#include <cstring>

#include "io/faces.h"
#include "io/readers.h"
#include "io/text_scan.h"

namespace arris {
namespace {

constexpr std::size_t triangles_between_ticks = 4096;
constexpr std::size_t header_bytes = 84;    // a comment of 80 and the count
constexpr std::size_t triangle_bytes = 50;  // normal, three corners, two bytes of anything

// Numbers corners by their coordinates, in order of first appearance: open addressing.
class CornerJoiner {
 public:
  explicit CornerJoiner(std::vector<Vec3>& positions)
      : positions_(positions), table_(64, no_index) {}

  Index join(const Source& source, Vec3 p) {
    if (2 * positions_.size() >= table_.size()) grow(source);
    const std::size_t slot = find(p);
    if (table_[slot] == no_index) {
      require_indexable(source, positions_.size() + 1);
      table_[slot] = static_cast<Index>(positions_.size());
      positions_.push_back(p);
    }
    return table_[slot];
  }

 private:
  // Equal numbers have equal bits, but for the two zeros. NaNs are equal if their bits are.
  static std::array<std::uint64_t, 3> key(Vec3 p) {
    const auto bits = [](double v) { return std::bit_cast<std::uint64_t>(v == 0 ? 0.0 : v); };
    return {bits(p.x), bits(p.y), bits(p.z)};
  }

  // The slot of `p`, or the empty one where it belongs.
  std::size_t find(Vec3 p) const {
    const auto k = key(p);
    std::uint64_t hash = 0;
    for (const std::uint64_t word : k) {
      // Doubles of few digits differ in their high bits alone: fold those down, multiply (by 2^64
      // over the golden ratio, which mixes upwards), and fold down again.
      hash ^= word ^ (word >> 32);
      hash *= 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    std::size_t slot = hash & (table_.size() - 1);
    while (table_[slot] != no_index && key(positions_[table_[slot]]) != k)
      slot = (slot + 1) & (table_.size() - 1);
    return slot;
  }

  void grow(const Source& source) {
    require_memory(source, "corners", 2 * table_.size(), sizeof(Vec3));
    table_.assign(2 * table_.size(), no_index);
    for (std::size_t v = 0; v < positions_.size(); ++v)
      table_[find(positions_[v])] = static_cast<Index>(v);
  }

  std::vector<Vec3>& positions_;
  std::vector<Index> table_;  // a power of two, at most half full
};

std::uint32_t little_u32(const char* bytes) {
  std::uint32_t value = 0;
  for (int k = 3; k >= 0; --k) value = value << 8 | static_cast<unsigned char>(bytes[k]);
  return value;
}

std::uint64_t binary_count(const Source& source) {
  return little_u32(source.bytes.data() + 80);
}

bool has_binary_size(const Source& source) {
  return source.bytes.size() >= header_bytes &&
         source.bytes.size() == header_bytes + triangle_bytes * binary_count(source);
}

Shape read_binary(const Source& source) {
  const std::uint64_t count = binary_count(source);
  const std::uint64_t room = (source.bytes.size() - header_bytes) / triangle_bytes;
  if (count > room)
    malformed(source, "triangle " + std::to_string(room) + " of " + std::to_string(count),
              "file ends early", remedy_incomplete);
  if (!has_binary_size(source))
    malformed(source, "",
              "goes on after the " + std::to_string(count) + " triangles that its header declares");
  require_memory(source, "triangles", count, sizeof(Triangle));
  Shape shape;
  shape.position_type = ScalarType::f32;
  shape.triangles.reserve(count);
  CornerJoiner joiner(shape.positions);
  for (std::uint64_t t = 0; t < count; ++t) {
    if (t % triangles_between_ticks == 0)
      source.job.tick(static_cast<double>(t) / static_cast<double>(count));
    const char* corner = source.bytes.data() + header_bytes + t * triangle_bytes + 12;
    Triangle triangle;
    for (Index& v : triangle) {
      const auto number = [&](std::size_t k) {
        return static_cast<double>(std::bit_cast<float>(little_u32(corner + 4 * k)));
      };
      v = joiner.join(source, {number(0), number(1), number(2)});
      corner += 12;
    }
    shape.triangles.push_back(triangle);
  }
  return shape;
}

class AsciiStl {
 public:
  explicit AsciiStl(const Source& source)
      : source_(source),
        lines_(source.bytes),
        joiner_(shape_.positions),
        limit_(memory_limit(source.job.context()) / sizeof(Triangle)) {}

  Shape read() {
    require_text(source_);
    while (lines_.next_filled()) {
      if (lines_.number() % triangles_between_ticks == 0) source_.job.tick(lines_.fraction());
      std::string_view rest = lines_.line();
      take(lower_case(next_field(rest)), rest);
    }
    if (open_) malformed(source_, where(), "file ends before endsolid", remedy_incomplete);
    return std::move(shape_);
  }

 private:
  void take(const std::string& keyword, std::string_view rest) {
    if (keyword == "solid") {
      open_ = true;
    } else if (keyword == "endsolid") {
      if (corners_ != 0) malformed(source_, where(), "the solid ends within a facet");
      open_ = false;
    } else if (keyword == "vertex") {
      take_vertex(rest);
    } else if (keyword == "endfacet") {
      if (corners_ != 3)
        malformed(source_, where(),
                  "has " + std::to_string(corners_) + " corners where 3 are needed");
      if (shape_.triangles.size() >= limit_)
        require_memory(source_, "triangles", shape_.triangles.size() + 1, sizeof(Triangle));
      shape_.triangles.push_back(triangle_);
      corners_ = 0;
    } else if (keyword != "facet" && keyword != "outer" && keyword != "endloop") {
      malformed(source_, at_line(lines_.number()), quoted(keyword) + " is not a keyword of STL");
    }
  }

  void take_vertex(std::string_view rest) {
    std::array<double, 3> p{};
    for (double& v : p) {
      const std::string_view text = next_field(rest);
      if (!parse_number(text, v)) need_number(source_, where(), text);
    }
    if (corners_ == 3) malformed(source_, where(), "has more than 3 corners");
    triangle_[corners_++] = joiner_.join(source_, {p[0], p[1], p[2]});
  }

  std::string where() const {
    return at_line(lines_.number()) + ", triangle " + std::to_string(shape_.triangles.size());
  }

  const Source& source_;
  LineScanner lines_;
  Shape shape_;
  CornerJoiner joiner_;
  std::uint64_t limit_;  // triangles that fit in memory
  Triangle triangle_{};
  std::size_t corners_ = 0;
  bool open_ = false;
};

}  // namespace

Shape read_stl(const Source& source) {
  // Binary files may start with "solid" too, so the size decides first.
  if (has_binary_size(source)) return read_binary(source);
  LineScanner lines(source.bytes);
  if (lines.next_filled()) {
    std::string_view first = lines.line();
    const bool text = source.bytes.substr(0, 4096).find('\0') == source.bytes.npos;
    if (text && lower_case(next_field(first)) == "solid") return AsciiStl(source).read();
  }
  if (source.bytes.size() >= header_bytes) return read_binary(source);
  malformed(source, "", "is neither an ascii nor a binary STL file",
            "give it the extension of its real format");
}

}  // namespace arris
