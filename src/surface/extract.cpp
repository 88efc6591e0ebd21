#include "surface/extract.h"

namespace arris {
namespace {

// Renumbers the corners of all cells by the points they use, in the order of the points.
template <class Cell>
std::vector<Index> compact(std::size_t points, std::vector<Cell>& cells) {
  std::vector<Index> number(points, no_index), used;
  for (const Cell& cell : cells)
    for (Index v : cell) number[v] = 0;
  for (std::size_t v = 0; v < points; ++v)
    if (number[v] == 0) {
      number[v] = static_cast<Index>(used.size());
      used.push_back(static_cast<Index>(v));
    }
  for (Cell& cell : cells)
    for (Index& v : cell) v = number[v];
  return used;
}

}  // namespace

std::vector<Triangle> boundary_triangles(const TetMesh& mesh, const Labels& labels) {
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < mesh.finite; ++t) {
    if (!labels[t]) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      if (labels[mesh.neighbours[t][i]]) continue;
      const auto& k = facet_corners[i];
      triangles.push_back({mesh.vertices[t][static_cast<std::size_t>(k[0])],
                           mesh.vertices[t][static_cast<std::size_t>(k[1])],
                           mesh.vertices[t][static_cast<std::size_t>(k[2])]});
    }
  }
  return triangles;
}

std::vector<std::uint8_t> corners_of(const std::vector<Triangle>& triangles, std::size_t points) {
  std::vector<std::uint8_t> used(points, 0);
  for (const Triangle& t : triangles)
    for (Index v : t) used[v] = 1;
  return used;
}

ExtractedSurface extract_surface(const TetMesh& mesh, const Labels& labels) {
  ExtractedSurface surface{{}, boundary_triangles(mesh, labels)};
  surface.point = compact(mesh.points.size(), surface.triangles);
  return surface;
}

ExtractedSolid extract_solid(const TetMesh& mesh, const Labels& labels) {
  ExtractedSolid solid;
  for (std::size_t t = 0; t < mesh.finite; ++t)
    if (labels[t]) solid.tetrahedra.push_back(mesh.vertices[t]);
  solid.point = compact(mesh.points.size(), solid.tetrahedra);
  return solid;
}

}  // namespace arris
