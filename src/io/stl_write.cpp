#include <algorithm>
#include <cmath>

#include "base/failure.h"
#include "base/vec.h"
#include "io/writers.h"

namespace arris {
namespace {

// The unit normal, or zero if there is none. Edges are scaled to at most 1 first, so that their
// products neither overflow nor vanish.
Vec3 unit_normal(Vec3 a, Vec3 b, Vec3 c) {
  Vec3 u = b - a, v = c - a;
  double size = 0;
  for (const double s : {u.x, u.y, u.z, v.x, v.y, v.z}) size = std::max(size, std::fabs(s));
  if (!(size > 0) || !is_finite(u) || !is_finite(v)) return {};
  u = {u.x / size, u.y / size, u.z / size};
  v = {v.x / size, v.y / size, v.z / size};
  const Vec3 normal = cross(u, v);
  const double area = length(normal);
  return area > 0 ? Vec3{normal.x / area, normal.y / area, normal.z / area} : Vec3{};
}

void write_binary(AtomicFile& file, const Mesh& mesh, Job& job) {
  std::string header = "arris, binary STL";  // must not start with "solid"
  header.resize(80, ' ');
  file.text(header);
  file.binary(static_cast<std::uint32_t>(mesh.triangles.size()));
  Ticker tick(job, 0, 1, mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    tick(t);
    const auto [a, b, c] = mesh.triangles[t];
    const Vec3 corners[] = {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    const Vec3 normal = unit_normal(corners[0], corners[1], corners[2]);
    for (const Vec3 p : {normal, corners[0], corners[1], corners[2]})
      for (const double s : {p.x, p.y, p.z}) file.binary(static_cast<float>(s));
    file.binary(std::uint16_t{0});
  }
}

void write_ascii(AtomicFile& file, const Mesh& mesh, Job& job) {
  file.text("solid arris\n");
  Ticker tick(job, 0, 1, mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    tick(t);
    const auto [a, b, c] = mesh.triangles[t];
    const Vec3 normal = unit_normal(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
    file.text("facet normal ");
    write_position(file, normal);
    file.text("\nouter loop\n");
    for (const Index v : mesh.triangles[t]) {
      file.text("vertex ");
      write_position(file, mesh.vertices[v]);
      file.text("\n");
    }
    file.text("endloop\nendfacet\n");
  }
  file.text("endsolid arris\n");
}

}  // namespace

void write_stl(AtomicFile& file, const Mesh& mesh, Job& job) {
  const bool countable = mesh.triangles.size() <= 0xFFFFFFFFu;  // of a binary file
  if (countable && all_float(mesh.vertices))
    write_binary(file, mesh, job);
  else
    write_ascii(file, mesh, job);
}

}  // namespace arris
