// Wavefront OBJ: the lines v and f; all others (vn, vt, g, o, usemtl, l, ...) are passed over.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "io/faces.h"
#include "io/readers.h"
#include "io/text_fields.h"
#include "io/text_scan.h"

namespace arris {
namespace {

constexpr std::size_t lines_between_ticks = 4096;

class ObjReader {
 public:
  ObjReader(const Source& source, Want want)
      : source_(source), want_(want), lines_(source.bytes), faces_(source, shape_.triangles, 1) {}

  Shape read() {
    require_text(source_);
    const std::uint64_t lines = lines_.count_remaining();
    while (lines_.next_content()) {
      if (++statements_ % lines_between_ticks == 0) source_.job.tick(lines_.fraction());
      std::string_view rest = joined();
      const std::string_view keyword = next_field(rest);
      if (keyword == "v")
        take_vertex(rest, lines);
      else if (keyword == "f")
        take_face(rest);
    }
    if (want_ == Want::points && skipped_faces_ > 0)
      shape_.warnings.push_back(std::to_string(skipped_faces_) + " faces are left out");
    faces_.check(shape_.positions.size());
    finish_colours();
    return std::move(shape_);
  }

 private:
  // The current line, with those after it for as long as a backslash ends one.
  std::string_view joined() {
    if (!lines_.line().ends_with('\\')) return lines_.line();
    joined_ = lines_.line();
    do {
      joined_.back() = ' ';
      if (!lines_.next()) break;
      joined_ += trimmed(lines_.line());
    } while (joined_.ends_with('\\'));
    return joined_;
  }

  std::string where() const {
    return at_line(lines_.number()) + ", vertex " + std::to_string(shape_.positions.size() + 1);
  }

  // x y z [w] [r g b]
  void take_vertex(std::string_view rest, std::uint64_t lines) {
    if (shape_.positions.empty()) {
      constexpr std::uint64_t shortest = 7;  // bytes of a vertex: "v 0 0 0"
      const std::uint64_t most =
          std::min<std::uint64_t>(lines, source_.bytes.size() / shortest + 1);
      require_memory(source_, "vertices", most, sizeof(Vec3));
    }
    std::array<double, 7> numbers{};
    std::size_t count = 0;
    for (std::string_view text = next_field(rest); !text.empty(); text = next_field(rest)) {
      if (count == numbers.size()) fail_width("more than 7");
      if (!parse_number(text, numbers[count])) need_number(source_, where(), text);
      ++count;
    }
    if (count < 3 || count == 5) fail_width(std::to_string(count));
    if (count == 4 || count == 7) has_weights_ = true;
    require_indexable(source_, shape_.positions.size() + 1);
    shape_.positions.push_back({numbers[0], numbers[1], numbers[2]});
    if (count < 6) return;
    ++coloured_;
    for (std::size_t k = 0; k < 3; ++k) colours_[k].push_back(numbers[count - 3 + k]);
  }

  [[noreturn]] void fail_width(const std::string& count) const {
    malformed(source_, where(), "has " + count + " numbers where 3, 4, 6 or 7 are expected");
  }

  void take_face(std::string_view rest) {
    if (want_ == Want::points) {
      ++skipped_faces_;
      return;
    }
    std::uint64_t corners = 0;
    std::string_view ahead = rest;
    while (!next_field(ahead).empty()) ++corners;
    faces_.begin(corners, lines_.number());
    for (std::uint64_t k = 0; k < corners; ++k) faces_.corner(vertex_number(next_field(rest)));
    faces_.end();
  }

  // The vertex of "v", "v/vt", "v//vn" or "v/vt/vn", numbered from 1; negative ones count back
  // from the last vertex so far.
  double vertex_number(std::string_view text) const {
    const std::string_view digits = text.substr(0, text.find('/'));
    std::int64_t number = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, number);
    if (stop != end || error != std::errc{})
      malformed(source_, faces_.where(), quoted(text) + " is not a vertex number");
    if (number >= 0) return static_cast<double>(number);
    const auto vertices = static_cast<std::int64_t>(shape_.positions.size());
    if (number < -vertices)
      malformed(source_, faces_.where(),
                "names vertex " + std::to_string(number) + ", but only " +
                    std::to_string(vertices) + " come before it");
    return static_cast<double>(vertices + number + 1);
  }

  // Colours count if every vertex has one. They are bytes if written as bytes, or as exact 255ths.
  void finish_colours() {
    if (has_weights_) shape_.warnings.emplace_back("weights of vertices (w) are left out");
    if (coloured_ == 0) return;
    if (coloured_ < shape_.positions.size()) {
      shape_.warnings.emplace_back("colours are left out, for some vertices have none");
      return;
    }
    const bool bytes = std::all_of(colours_.begin(), colours_.end(), are_bytes);
    const bool above = std::any_of(colours_.begin(), colours_.end(),
                                   [](const auto& c) { return any_above(c, 1); });
    const bool parts = std::all_of(colours_.begin(), colours_.end(), are_255ths);
    static constexpr const char* names[] = {"red", "green", "blue"};
    for (std::size_t k = 0; k < 3; ++k) {
      if (parts)
        for (double& v : colours_[k]) v = std::round(v * 255);
      const ScalarType type = parts || (bytes && above) ? ScalarType::u8 : ScalarType::f64;
      shape_.attributes.push_back({names[k], type, std::move(colours_[k])});
    }
  }

  static bool are_255ths(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(),
                       [](double v) { return v >= 0 && v <= 1 && v == std::round(v * 255) / 255; });
  }

  const Source& source_;
  Want want_;
  LineScanner lines_;
  Shape shape_;
  FaceBuilder faces_;
  std::string joined_;
  std::uint64_t statements_ = 0, skipped_faces_ = 0, coloured_ = 0;
  std::array<std::vector<double>, 3> colours_;
  bool has_weights_ = false;
};

}  // namespace

Shape read_obj(const Source& source, Want want) {
  return ObjReader(source, want).read();
}

}  // namespace arris
