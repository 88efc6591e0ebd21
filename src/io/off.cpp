// Object File Format of Geomview: OFF, with N (normals), C (colours) and ST (texture) vertices.
#include <algorithm>
#include <string>

#include "io/faces.h"
#include "io/readers.h"
#include "io/text_fields.h"
#include "io/text_scan.h"

namespace arris {
namespace {

constexpr std::size_t rows_between_ticks = 4096;

class OffReader {
 public:
  explicit OffReader(const Source& source) : source_(source), lines_(source.bytes) {}

  Shape read(Want want) {
    require_text(source_);
    read_header();
    read_vertices();
    if (want == Want::mesh)
      read_faces();
    else if (faces_ > 0)
      shape_.warnings.push_back(std::to_string(faces_) + " faces are left out");
    return std::move(shape_);
  }

 private:
  // The keyword and the counts, on one line or two.
  void read_header() {
    if (!lines_.next_content())
      malformed(source_, "", "ends before the keyword OFF", remedy_incomplete);
    std::string_view rest = lines_.line();
    take_keyword(next_field(rest));
    if (trimmed(rest).starts_with("BINARY"))
      fail(source_, ErrorCode::unsupported, at_line(lines_.number()), "is a binary OFF file",
           "export it as an ascii OFF or a PLY file");
    if (trimmed(rest).empty()) {
      if (!lines_.next_content())
        malformed(source_, at_line(lines_.number()), "file ends before the counts",
                  remedy_incomplete);
      rest = lines_.line();
    }
    const std::string_view vertices = next_field(rest), faces = next_field(rest);
    vertices_ = need_count(source_, at_line(lines_.number()), vertices);
    faces_ = need_count(source_, at_line(lines_.number()), faces);
    require_room("vertices", vertices_, 6);  // "0 0 0\n"
    require_indexable(source_, vertices_);
  }

  void take_keyword(std::string_view keyword) {
    std::string_view prefix = keyword;
    if (!keyword.ends_with("OFF"))
      malformed(source_, at_line(lines_.number()), "starts with " + quoted(keyword) + ", not OFF",
                "give the file the extension of its real format");
    prefix.remove_suffix(3);
    const auto take = [&](std::string_view mark) {
      if (!prefix.starts_with(mark)) return false;
      prefix.remove_prefix(mark.size());
      return true;
    };
    texture_ = take("ST");
    // Programs disagree on the order of these two.
    colours_ = take("C");
    normals_ = take("N");
    colours_ = colours_ || take("C");
    if (!prefix.empty())
      fail(source_, ErrorCode::unsupported, at_line(lines_.number()),
           quoted(keyword) + " is a kind of OFF that arris does not read",
           "export it as a plain OFF or a PLY file");
  }

  // Whether `count` things, of which `have` are read, can be there if each takes `shortest` bytes.
  void require_room(const std::string& what, std::uint64_t count, std::uint64_t shortest,
                    std::uint64_t have = 0) const {
    const std::uint64_t room = have + (lines_.remaining() + 1) / shortest;
    if (count > room)
      malformed(source_, at_line(lines_.number()),
                "file ends early, " + std::to_string(count) + " " + what +
                    " are declared and at most " + std::to_string(room) + " fit",
                remedy_incomplete);
  }

  void read_vertices() {
    for (std::uint64_t v = 0; v < vertices_; ++v) {
      if (v % rows_between_ticks == 0) source_.job.tick(lines_.fraction());
      if (!lines_.next_content())
        malformed(source_, current_vertex(), "file ends early", remedy_incomplete);
      read_row();
      if (v == 0) start_vertices();
      if (row_.size() != 3 + shape_.attributes.size()) fail_width(3 + shape_.attributes.size());
      shape_.positions.push_back({row_[0], row_[1], row_[2]});
      for (std::size_t k = 3; k < row_.size(); ++k)
        shape_.attributes[k - 3].values.push_back(row_[k]);
    }
    type_colours(shape_.attributes);
  }

  std::string current_vertex() const {
    return "vertex " + std::to_string(shape_.positions.size()) + " of " + std::to_string(vertices_);
  }

  [[noreturn]] void fail_width(std::size_t expected) const {
    malformed(source_, at_line(lines_.number()) + ", " + current_vertex(),
              "has " + std::to_string(row_.size()) + " numbers where " + std::to_string(expected) +
                  " are expected");
  }

  void read_row() {
    row_.clear();
    std::string_view rest = lines_.line();
    for (std::string_view text = next_field(rest); !text.empty(); text = next_field(rest)) {
      row_.push_back(0);
      if (!parse_number(text, row_.back()))
        need_number(source_, at_line(lines_.number()) + ", " + current_vertex(), text);
    }
  }

  // Names the columns by the keyword and the first vertex, whose colour may have an alpha.
  void start_vertices() {
    std::vector<std::string> names;
    if (normals_) names.insert(names.end(), {"nx", "ny", "nz"});
    if (colours_) names.insert(names.end(), {"red", "green", "blue"});
    if (colours_ && row_.size() == 4 + names.size() + (texture_ ? 2 : 0))
      names.emplace_back("alpha");
    if (texture_) names.insert(names.end(), {"s", "t"});
    constexpr std::size_t most_columns = 1024;  // more are garbage
    if (row_.size() < 3 + names.size() || row_.size() > most_columns) fail_width(3 + names.size());
    for (std::size_t k = 3 + names.size(); k < row_.size(); ++k) names.push_back(column_name(k));
    require_room("vertices", vertices_, 2 * row_.size(), 1);  // "0 0 0\n"
    require_memory(source_, "vertices", vertices_, sizeof(double) * row_.size());
    shape_.positions.reserve(vertices_);
    for (const std::string& name : names) {
      shape_.attributes.push_back({name, ScalarType::f64, {}});
      shape_.attributes.back().values.reserve(vertices_);
    }
  }

  void read_faces() {
    require_room("faces", faces_, 2);
    FaceBuilder faces(source_, shape_.triangles, 0);
    for (std::uint64_t f = 0; f < faces_; ++f) {
      if (f % rows_between_ticks == 0) source_.job.tick(lines_.fraction());
      if (!lines_.next_content())
        malformed(source_, "face " + std::to_string(f) + " of " + std::to_string(faces_),
                  "file ends early", remedy_incomplete);
      std::string_view rest = lines_.line();
      const std::string_view size = next_field(rest);
      const std::uint64_t corners = need_count(source_, at_line(lines_.number()), size);
      if (corners > rest.size())
        malformed(source_, at_line(lines_.number()) + ", face " + std::to_string(f),
                  "is shorter than its " + std::to_string(corners) + " corners");
      faces.begin(corners, lines_.number());
      for (std::uint64_t k = 0; k < corners; ++k) {
        double number = 0;
        const std::string_view text = next_field(rest);
        if (!parse_number(text, number)) need_number(source_, faces.where(), text);
        faces.corner(number);
      }
      faces.end();  // what follows on the line is the colour of the face
    }
    if (lines_.next_content())
      malformed(source_, at_line(lines_.number()), "comes after the last declared face");
    faces.check(shape_.positions.size());
  }

  const Source& source_;
  LineScanner lines_;
  bool normals_ = false, colours_ = false, texture_ = false;
  std::uint64_t vertices_ = 0, faces_ = 0;
  std::vector<double> row_;
  Shape shape_;
};

}  // namespace

Shape read_off(const Source& source, Want want) {
  return OffReader(source).read(want);
}

}  // namespace arris
