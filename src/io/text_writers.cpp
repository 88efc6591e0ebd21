// Writers of text formats, and what all writers share.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/failure.h"
#include "io/writers.h"

namespace arris {
namespace {

constexpr const char* remedy_inconsistent = "correct the data given to the writer";

template <std::size_t corners>
void require_corners(const std::string& path, const std::vector<std::array<Index, corners>>& cells,
                     std::size_t vertices) {
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const Index v : cells[c])
      if (v >= vertices)
        throw Failure(ErrorCode::usage,
                      "'" + path + "': element " + std::to_string(c) + " names vertex " +
                          std::to_string(v) + ", but there are " + std::to_string(vertices),
                      remedy_inconsistent);
}

void require_values(const std::string& path, const std::vector<Attribute>& attributes,
                    std::size_t count, const char* things) {
  for (const Attribute& a : attributes)
    if (a.values.size() != count)
      throw Failure(ErrorCode::usage,
                    "'" + path + "': attribute '" + a.name + "' has " +
                        std::to_string(a.values.size()) + " values for " + std::to_string(count) +
                        " " + things,
                    remedy_inconsistent);
}

// The three colours, if the mesh has them as bytes; otherwise nulls.
std::array<const Attribute*, 3> byte_colours(const Mesh& mesh) {
  std::array<const Attribute*, 3> colours{};
  for (const Attribute& a : mesh.attributes) {
    if (a.type != ScalarType::u8) continue;
    if (a.name == "red") colours[0] = &a;
    if (a.name == "green") colours[1] = &a;
    if (a.name == "blue") colours[2] = &a;
  }
  return colours[0] && colours[1] && colours[2] ? colours : std::array<const Attribute*, 3>{};
}

// The numbers of the smooth patches, if the faces have them.
const Attribute* patch_of_faces(const Mesh& mesh) {
  for (const Attribute& a : mesh.face_attributes)
    if (a.name == "patch" && a.type == ScalarType::i32) return &a;
  return nullptr;
}

// One line: `prefix`, then the indices plus `base`, each after a blank.
template <std::size_t corners>
void write_cell(AtomicFile& file, std::string_view prefix, const std::array<Index, corners>& cell,
                std::uint64_t base) {
  file.text(prefix);
  for (const Index v : cell) {
    file.text(" ");
    file.number(base + v);
  }
  file.text("\n");
}

}  // namespace

void require_consistent(const std::string& path, const Mesh& mesh) {
  require_values(path, mesh.attributes, mesh.vertices.size(), "vertices");
  require_values(path, mesh.face_attributes, mesh.triangles.size(), "triangles");
  require_corners(path, mesh.triangles, mesh.vertices.size());
}

void require_consistent(const std::string& path, const TetVolume& volume) {
  require_corners(path, volume.tetrahedra, volume.vertices.size());
}

void write_position(AtomicFile& file, Vec3 p) {
  file.number(p.x);
  file.text(" ");
  file.number(p.y);
  file.text(" ");
  file.number(p.z);
}

bool is_float(double v) noexcept {
  if (!std::isfinite(v)) return true;
  if (std::fabs(v) > static_cast<double>(std::numeric_limits<float>::max())) return false;
  return static_cast<double>(static_cast<float>(v)) == v;
}

bool all_float(const std::vector<Vec3>& positions) noexcept {
  for (const Vec3& p : positions)
    if (!is_float(p.x) || !is_float(p.y) || !is_float(p.z)) return false;
  return true;
}

void write_off(AtomicFile& file, const Mesh& mesh, Job& job) {
  file.text("OFF\n");
  file.number(mesh.vertices.size());
  file.text(" ");
  file.number(mesh.triangles.size());
  file.text(" 0\n");
  Ticker tick_vertex(job, 0, 0.5, mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    tick_vertex(v);
    write_position(file, mesh.vertices[v]);
    file.text("\n");
  }
  Ticker tick_face(job, 0.5, 1, mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    tick_face(t);
    write_cell(file, "3", mesh.triangles[t], 0);
  }
}

void write_obj(AtomicFile& file, const Mesh& mesh, Job& job) {
  const std::array<const Attribute*, 3> colours = byte_colours(mesh);
  Ticker tick_vertex(job, 0, 0.5, mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    tick_vertex(v);
    file.text("v ");
    write_position(file, mesh.vertices[v]);
    for (const Attribute* colour : colours) {
      if (!colour) break;
      file.text(" ");
      file.number(colour->values[v] / 255);
    }
    file.text("\n");
  }
  const Attribute* const patch = patch_of_faces(mesh);
  std::vector<std::size_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (patch)
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return patch->values[a] < patch->values[b];
    });
  Ticker tick_face(job, 0.5, 1, order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    tick_face(k);
    if (patch && (k == 0 || patch->values[order[k]] != patch->values[order[k - 1]])) {
      file.text("g patch_");
      file.number(patch->values[order[k]]);
      file.text("\n");
    }
    write_cell(file, "f", mesh.triangles[order[k]], 1);
  }
}

void write_msh(AtomicFile& file, const TetVolume& volume, Job& job) {
  file.text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n");
  file.number(volume.vertices.size());
  file.text("\n");
  Ticker tick_vertex(job, 0, 0.5, volume.vertices.size());
  for (std::size_t v = 0; v < volume.vertices.size(); ++v) {
    tick_vertex(v);
    file.number(v + 1);
    file.text(" ");
    write_position(file, volume.vertices[v]);
    file.text("\n");
  }
  file.text("$EndNodes\n$Elements\n");
  file.number(volume.tetrahedra.size());
  file.text("\n");
  Ticker tick_cell(job, 0.5, 1, volume.tetrahedra.size());
  for (std::size_t t = 0; t < volume.tetrahedra.size(); ++t) {
    tick_cell(t);
    file.number(t + 1);
    write_cell(file, " 4 2 1 1", volume.tetrahedra[t], 1);  // a tetrahedron; two tags, both 1
  }
  file.text("$EndElements\n");
}

void write_vtk(AtomicFile& file, const TetVolume& volume, Job& job) {
  const std::size_t cells = volume.tetrahedra.size();
  file.text(
      "# vtk DataFile Version 3.0\ntetrahedra by arris\nASCII\n"
      "DATASET UNSTRUCTURED_GRID\nPOINTS ");
  file.number(volume.vertices.size());
  file.text(" double\n");
  Ticker tick_vertex(job, 0, 0.5, volume.vertices.size());
  for (std::size_t v = 0; v < volume.vertices.size(); ++v) {
    tick_vertex(v);
    write_position(file, volume.vertices[v]);
    file.text("\n");
  }
  file.text("CELLS ");
  file.number(cells);
  file.text(" ");
  file.number(5 * cells);
  file.text("\n");
  Ticker tick_cell(job, 0.5, 0.9, cells);
  for (std::size_t t = 0; t < cells; ++t) {
    tick_cell(t);
    write_cell(file, "4", volume.tetrahedra[t], 0);
  }
  file.text("CELL_TYPES ");
  file.number(cells);
  file.text("\n");
  Ticker tick_type(job, 0.9, 1, cells);
  for (std::size_t t = 0; t < cells; ++t) {
    tick_type(t);
    file.text("10\n");  // VTK_TETRA
  }
}

}  // namespace arris
