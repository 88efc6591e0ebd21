#include <algorithm>
#include <limits>

#include "io/faces.h"
#include "io/ply_body.h"
#include "io/readers.h"

namespace arris {
namespace {

constexpr std::size_t rows_between_ticks = 4096;
constexpr std::size_t no_slot = std::numeric_limits<std::size_t>::max();

// What becomes of each vertex property: a coordinate (slot 0 to 2), an attribute (3 + its index),
// or nothing.
std::vector<std::size_t> plan_vertices(const Source& source, const PlyElement& element,
                                       Shape& shape) {
  std::vector<std::size_t> slots;
  std::array<const PlyProperty*, 3> axes{};
  for (const PlyProperty& p : element.properties) {
    if (p.is_list) {
      slots.push_back(no_slot);
      shape.warnings.push_back("list property " + quoted(p.name) + " of the vertices is left out");
    } else if (p.name == "x" || p.name == "y" || p.name == "z") {
      slots.push_back(static_cast<std::size_t>(p.name[0] - 'x'));
      axes[slots.back()] = &p;
    } else {
      slots.push_back(3 + shape.attributes.size());
      shape.attributes.push_back({p.name, p.type, {}});
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (!axes[k])
      malformed(source, "element vertex", "has no property " + std::string(1, "xyz"[k]),
                "export the file with the positions x, y and z");
  const bool same = axes[0]->type == axes[1]->type && axes[1]->type == axes[2]->type;
  shape.position_type = same ? axes[0]->type : ScalarType::f64;
  return slots;
}

template <class Body>
void read_vertices(Body& body, const Source& source, const PlyElement& element, Shape& shape) {
  const std::vector<std::size_t> slots = plan_vertices(source, element, shape);
  body.require(element);
  require_indexable(source, element.count);
  require_memory(source, "vertices", element.count,
                 sizeof(Vec3) + sizeof(double) * shape.attributes.size());
  shape.positions.resize(element.count);
  for (Attribute& a : shape.attributes) a.values.resize(element.count);
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (row % rows_between_ticks == 0) source.job.tick(body.fraction());
    body.begin_row(element, row);
    std::array<double, 3> position{};
    for (std::size_t k = 0; k < slots.size(); ++k) {
      const PlyProperty& p = element.properties[k];
      if (p.is_list)
        body.skip(p.type, body.list_size(p.count_type));
      else if (slots[k] < 3)
        position[slots[k]] = body.coordinate(p.type);
      else
        shape.attributes[slots[k] - 3].values[row] = body.scalar(p.type);
    }
    body.end_row();
    shape.positions[row] = {position[0], position[1], position[2]};
  }
}

bool is_corner_list(const PlyProperty& p) {
  return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
}

// The scalar properties of the faces become attributes, as long as every face is a triangle:
// polygons are cut, and one with many corners and properties would take memory in proportion to the
// product of both.
class FaceAttributes {
 public:
  FaceAttributes(const PlyElement& element, Shape& shape) : shape_(shape) {
    for (const PlyProperty& p : element.properties)
      if (!p.is_list) shape.face_attributes.push_back({p.name, p.type, {}});
    for (Attribute& a : shape.face_attributes) a.values.reserve(element.count);
  }
  // The next value of the current face.
  void take(double value) {
    if (next_ < shape_.face_attributes.size())
      shape_.face_attributes[next_++].values.push_back(value);
  }
  // After the row of the face whose number, from 0, is `row`.
  void end_face(std::uint64_t row) {
    next_ = 0;
    if (shape_.triangles.size() != row + 1) shape_.face_attributes.clear();
  }

 private:
  Shape& shape_;
  std::size_t next_ = 0;
};

template <class Body>
void read_faces(Body& body, const Source& source, const PlyElement& element, FaceBuilder& faces,
                Shape& shape) {
  const auto lists =
      std::count_if(element.properties.begin(), element.properties.end(), is_corner_list);
  if (lists != 1)
    malformed(source, "element face", "needs one list vertex_indices or vertex_index",
              "export the file with the faces as lists of vertex indices");
  body.require(element);
  require_memory(source, "faces", element.count,
                 sizeof(Triangle) + sizeof(double) * element.properties.size());
  FaceAttributes attributes(element, shape);
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (row % rows_between_ticks == 0) source.job.tick(body.fraction());
    body.begin_row(element, row);
    for (const PlyProperty& p : element.properties) {
      if (!p.is_list) {
        attributes.take(body.scalar(p.type));
        continue;
      }
      const std::uint64_t size = body.list_size(p.count_type);
      if (!is_corner_list(p)) {
        body.skip(p.type, size);
        continue;
      }
      faces.begin(size, body.line());
      for (std::uint64_t k = 0; k < size; ++k) faces.corner(body.scalar(p.type));
      faces.end();
    }
    attributes.end_face(row);
    body.end_row();
  }
}

// Reads the elements in the order of the file and stops after the last one that is wanted.
template <class Body>
Shape read_body(Body body, const Source& source, const PlyHeader& header, Want want) {
  Shape shape;
  FaceBuilder faces(source, shape.triangles, 0);
  bool wants_vertices = true, wants_faces = want == Want::mesh, read_all = true;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      read_vertices(body, source, element, shape);
      wants_vertices = false;
    } else if (element.name == "face" && want == Want::mesh) {
      read_faces(body, source, element, faces, shape);
      wants_faces = false;
    } else {
      if (wants_vertices || wants_faces)
        body.skip_element(element);
      else
        read_all = false;
      if (element.count > 0)
        shape.warnings.push_back("element " + quoted(element.name) + " (" +
                                 std::to_string(element.count) + ") is left out");
    }
  }
  if (wants_vertices)
    malformed(source, "header", "declares no element vertex", "export the file with its vertices");
  if (read_all && body.has_more())
    shape.warnings.emplace_back("the file goes on after the last element that its header declares");
  faces.check(shape.positions.size());
  return shape;
}

}  // namespace

Shape read_ply(const Source& source, Want want) {
  const PlyHeader header = parse_ply_header(source);
  return header.format == PlyFormat::ascii
             ? read_body(AsciiBody(source, header), source, header, want)
             : read_body(BinaryBody(source, header), source, header, want);
}

}  // namespace arris
