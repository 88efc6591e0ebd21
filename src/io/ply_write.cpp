#include <algorithm>
#include <cmath>
#include <limits>

#include "arris/version.h"
#include "io/ply_format.h"
#include "io/writers.h"

namespace arris {
namespace {

// Names that PLY can hold: no blanks, nothing unprintable, none of `names`, which mean
// something else, none twice.
std::vector<std::string> unique_names(const std::vector<Attribute>& attributes,
                                      std::vector<std::string> names) {
  const auto reserved = static_cast<std::ptrdiff_t>(names.size());
  for (const Attribute& a : attributes) {
    std::string name = a.name.empty() ? "attribute" : a.name;
    for (char& c : name)
      if (c <= ' ' || c > '~') c = '_';
    while (std::find(names.begin(), names.end(), name) != names.end()) name += '_';
    names.push_back(std::move(name));
  }
  names.erase(names.begin(), names.begin() + reserved);
  return names;
}

// Rounds to the nearest value of an integer type; NaN becomes 0.
template <class T>
T as_integer(double v) noexcept {
  constexpr double low = std::numeric_limits<T>::lowest(), high = std::numeric_limits<T>::max();
  return std::isnan(v) ? T{0} : static_cast<T>(std::clamp(std::round(v), low, high));
}

float as_float(double v) noexcept {
  constexpr double high = std::numeric_limits<float>::max();
  return static_cast<float>(std::isfinite(v) ? std::clamp(v, -high, high) : v);
}

void write_scalar(AtomicFile& file, ScalarType type, double v) {
  switch (type) {
    case ScalarType::i8:
      return file.binary(as_integer<std::int8_t>(v));
    case ScalarType::u8:
      return file.binary(as_integer<std::uint8_t>(v));
    case ScalarType::i16:
      return file.binary(as_integer<std::int16_t>(v));
    case ScalarType::u16:
      return file.binary(as_integer<std::uint16_t>(v));
    case ScalarType::i32:
      return file.binary(as_integer<std::int32_t>(v));
    case ScalarType::u32:
      return file.binary(as_integer<std::uint32_t>(v));
    case ScalarType::f32:
      return file.binary(as_float(v));
    case ScalarType::f64:
      return file.binary(v);
  }
}

void write_header(AtomicFile& file, const Mesh& mesh, ScalarType position, ScalarType index) {
  const auto property = [&](const std::string& type, const std::string& name) {
    file.text("property " + type + " " + name + "\n");
  };
  file.text("ply\nformat binary_little_endian 1.0\ncomment arris " ARRIS_VERSION "\n");
  file.text("element vertex " + std::to_string(mesh.vertices.size()) + "\n");
  for (const char* axis : {"x", "y", "z"}) property(ply_name(position), axis);
  const std::vector<std::string> names = unique_names(mesh.attributes, {"x", "y", "z"});
  for (std::size_t k = 0; k < names.size(); ++k)
    property(ply_name(mesh.attributes[k].type), names[k]);
  file.text("element face " + std::to_string(mesh.triangles.size()) + "\n");
  property(std::string("list uchar ") + ply_name(index), "vertex_indices");
  const std::vector<std::string> face_names =
      unique_names(mesh.face_attributes, {"vertex_indices", "vertex_index"});
  for (std::size_t k = 0; k < face_names.size(); ++k)
    property(ply_name(mesh.face_attributes[k].type), face_names[k]);
  file.text("end_header\n");
}

}  // namespace

void write_ply(AtomicFile& file, const Mesh& mesh, Job& job) {
  const bool floats = mesh.position_type == ScalarType::f32 && all_float(mesh.vertices);
  const ScalarType position = floats ? ScalarType::f32 : ScalarType::f64;
  // Most readers expect int; only a mesh too large for it gets uint.
  constexpr std::size_t int_range = std::size_t{1} << 31;
  const ScalarType index = mesh.vertices.size() <= int_range ? ScalarType::i32 : ScalarType::u32;
  write_header(file, mesh, position, index);
  Ticker tick_vertex(job, 0, 0.5, mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    tick_vertex(v);
    const Vec3 p = mesh.vertices[v];
    for (const double c : {p.x, p.y, p.z}) write_scalar(file, position, c);
    for (const Attribute& a : mesh.attributes) write_scalar(file, a.type, a.values[v]);
  }
  Ticker tick_face(job, 0.5, 1, mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    tick_face(t);
    file.binary(std::uint8_t{3});
    for (const Index v : mesh.triangles[t]) file.binary(v);  // below 2^31, int and uint are one
    for (const Attribute& a : mesh.face_attributes) write_scalar(file, a.type, a.values[t]);
  }
}

}  // namespace arris
