// The two makers of polyhedra: boundaries of boxes on a grid, and convex hulls of a few points.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

#include "base/vec.h"
#include "truth/measure.h"
#include "truth/shapes.h"

namespace arris::truth {
namespace {

using Cell = std::array<std::size_t, 3>;
using Coordinates = std::array<double, 3>;

Coordinates coordinates(Vec3 p) {
  return {p.x, p.y, p.z};
}

// The cells between all coordinates of the boxes, with an empty layer round them.
class CellGrid {
 public:
  explicit CellGrid(const std::vector<Box>& boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<double>& c = cuts_[axis];
      for (const Box& box : boxes)
        c.insert(c.end(), {coordinates(box.low)[axis], coordinates(box.high)[axis]});
      std::sort(c.begin(), c.end());
      c.erase(std::unique(c.begin(), c.end()), c.end());
    }
    solid_.resize((cuts_[0].size() + 1) * (cuts_[1].size() + 1) * (cuts_[2].size() + 1));
    for (const Box& box : boxes) fill(box);
  }

  // Cell i lies between cuts i-1 and i; 0 and the last are outside.
  std::size_t cells(std::size_t axis) const { return cuts_[axis].size() + 1; }
  bool solid(Cell c) const { return solid_[offset(c)]; }
  Vec3 corner(Cell c) const { return {cuts_[0][c[0]], cuts_[1][c[1]], cuts_[2][c[2]]}; }

 private:
  std::size_t offset(Cell c) const { return (c[0] * cells(1) + c[1]) * cells(2) + c[2]; }

  std::size_t cell_after(std::size_t axis, double cut) const {
    const auto& c = cuts_[axis];
    return static_cast<std::size_t>(std::lower_bound(c.begin(), c.end(), cut) - c.begin()) + 1;
  }

  void fill(const Box& box) {
    Cell low{}, high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = cell_after(axis, coordinates(box.low)[axis]);
      high[axis] = cell_after(axis, coordinates(box.high)[axis]);
    }
    for (std::size_t x = low[0]; x < high[0]; ++x)
      for (std::size_t y = low[1]; y < high[1]; ++y)
        for (std::size_t z = low[2]; z < high[2]; ++z) solid_[offset({x, y, z})] = box.solid;
  }

  std::array<std::vector<double>, 3> cuts_;
  std::vector<bool> solid_;
};

// Collects the quads between solid and empty cells, sharing vertices.
class QuadMesh {
 public:
  explicit QuadMesh(const CellGrid& grid) : grid_(grid) {}

  // The quad between `cell` and the next cell along `axis`, facing along it if `up`.
  void add(Cell cell, std::size_t axis, bool up) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    Cell a = cell;  // as cuts: the upper end of the cell along the axis, the lower ones across
    --a[u], --a[v];
    Cell b = a, c = a, d = a;
    ++b[u], ++c[u], ++c[v], ++d[v];
    if (!up) std::swap(b, d);
    const Index ia = vertex(a), ib = vertex(b), ic = vertex(c), id = vertex(d);
    mesh.triangles.push_back({ia, ib, ic});
    mesh.triangles.push_back({ia, ic, id});
  }

  Mesh mesh;

 private:
  Index vertex(Cell corner) {
    const auto [at, added] = index_.try_emplace(corner, static_cast<Index>(mesh.vertices.size()));
    if (added) mesh.vertices.push_back(grid_.corner(corner));
    return at->second;
  }

  const CellGrid& grid_;
  std::map<Cell, Index> index_;
};

// The corners of the hull face through points i, j, k in counter-clockwise order, or nothing if
// there is none or if i, j, k are not its three lowest indices.
std::vector<Index> hull_face(const std::vector<Vec3>& points, Index i, Index j, Index k) {
  constexpr double flat = 1e-9;  // relative to the size of the points, which is about 1
  Vec3 n = cross(points[j] - points[i], points[k] - points[i]);
  if (length(n) < flat) return {};
  n = (1 / length(n)) * n;
  std::vector<Index> face;
  double side = 0;
  for (Index p = 0; p < points.size(); ++p) {
    const double height = dot(n, points[p] - points[i]);
    if (std::abs(height) < flat) {
      face.push_back(p);
    } else {
      if (height * side < 0) return {};
      side = height;
    }
  }
  if (face[0] != i || face[1] != j || face[2] != k) return {};
  if (side > 0) n = -n;
  Vec3 centre;
  for (const Index p : face) centre = centre + (1.0 / static_cast<double>(face.size())) * points[p];
  const Vec3 u = points[i] - centre, v = cross(n, u);
  std::sort(face.begin(), face.end(), [&](Index l, Index r) {
    const auto angle = [&](Index p) {
      return std::atan2(dot(v, points[p] - centre), dot(u, points[p] - centre));
    };
    return angle(l) < angle(r);
  });
  return face;
}

}  // namespace

Mesh box_complex(const std::vector<Box>& boxes) {
  const CellGrid grid(boxes);
  QuadMesh quads(grid);
  for (std::size_t x = 0; x < grid.cells(0); ++x)
    for (std::size_t y = 0; y < grid.cells(1); ++y)
      for (std::size_t z = 0; z < grid.cells(2); ++z)
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Cell here = {x, y, z};
          Cell next = here;
          if (++next[axis] == grid.cells(axis)) continue;
          if (grid.solid(here) != grid.solid(next)) quads.add(here, axis, grid.solid(here));
        }
  require_manifold(quads.mesh);
  return std::move(quads.mesh);
}

Mesh convex_hull(const std::vector<Vec3>& points) {
  Mesh mesh;
  mesh.vertices = points;
  const Index n = static_cast<Index>(points.size());
  for (Index i = 0; i < n; ++i)
    for (Index j = i + 1; j < n; ++j)
      for (Index k = j + 1; k < n; ++k) {
        const std::vector<Index> face = hull_face(points, i, j, k);
        for (std::size_t c = 2; c < face.size(); ++c)
          mesh.triangles.push_back({face[0], face[c - 1], face[c]});
      }
  require_manifold(mesh);
  return mesh;
}

}  // namespace arris::truth
