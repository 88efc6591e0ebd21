// The value types a user meets: points, attributes, meshes. Plain data, no invariants hidden.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace arris {

// A position or direction, in the user's unit and frame.
struct Vec3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

// Index of a vertex or of a point. 32 bits: up to 4,294,967,294 points.
using Index = std::uint32_t;
inline constexpr Index no_index = 0xFFFFFFFFu;

// Three vertex indices, counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;

// The scalar types of PLY. Values of each fit exactly into a double.
enum class ScalarType : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };

// One named per-point value ("red", "nx", "intensity", ...). values.size() == number of points.
// `type` is the type it had in the file and is written back as.
struct Attribute {
  std::string name;
  ScalarType type = ScalarType::f32;
  std::vector<double> values;
  friend bool operator==(const Attribute&, const Attribute&) = default;
};

// Unorganised points with any number of attributes. `position_type` is what the file held (f32 or
// f64, or an integer type); it is a hint for writers and never reduces precision.
struct PointCloud {
  std::vector<Vec3> positions;
  std::vector<Attribute> attributes;
  ScalarType position_type = ScalarType::f64;
  std::vector<std::string> warnings;  // what the reader left behind, e.g. list properties
};

// A triangle mesh. Attributes are per vertex, those of `face_attributes` per triangle. `source[v]`
// is the index of the input point at vertex v, or no_index for a vertex that arris added; it is
// empty for a mesh that was read from a file. Attribute values of added vertices are 0.
struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<Attribute> attributes;
  std::vector<Attribute> face_attributes;
  std::vector<Index> source;
  ScalarType position_type = ScalarType::f64;
};

// The solid as tetrahedra (positively oriented: (b-a) x (c-a) . (d-a) > 0) over their own vertices.
struct TetVolume {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 4>> tetrahedra;
};

}  // namespace arris
