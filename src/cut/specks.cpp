#include "cut/specks.h"

#include <numbers>

#include "base/vec.h"
#include "tetra/geometry.h"

namespace arris {
namespace {

// Volume, in cubes of the spacing, of a ball of one spacing. The specks on 304 clean clouds had at
// most 1; a solid of two spacings a side, 26 samples, has 8.
constexpr double smallest_part = 4.0 / 3 * std::numbers::pi;

// A connected part of one label: a run of Parts::order.
struct Part {
  std::size_t begin = 0, end = 0;
  double volume = 0;  // in cubes of the local spacing
  std::uint8_t label = 0;
  bool infinite = false;
};

struct Parts {
  std::vector<Tet> order;
  std::vector<Part> parts;
};

// Volume of a tetrahedron in cubes of the spacing at its corners.
double relative_volume(const TetMesh& mesh, const std::vector<double>& spacing, Tet t) {
  const auto& v = mesh.vertices[t];
  const Vec3 a = mesh.points[v[0]];
  const double h = mean_spacing(mesh, spacing, t);
  return dot(cross(mesh.points[v[1]] - a, mesh.points[v[2]] - a), mesh.points[v[3]] - a) /
         (6 * h * h * h);
}

Parts connected_parts(const TetMesh& mesh, const std::vector<double>& spacing,
                      const Labels& labels) {
  Parts result;
  result.order.reserve(mesh.size());
  std::vector<std::uint8_t> seen(mesh.size(), 0);
  for (Tet first = 0; first < mesh.size(); ++first) {
    if (seen[first]) continue;
    Part part{result.order.size(), 0, 0, labels[first], false};
    seen[first] = 1;
    result.order.push_back(first);
    for (std::size_t k = part.begin; k < result.order.size(); ++k) {
      const Tet t = result.order[k];
      if (!mesh.is_finite(t))
        part.infinite = true;
      else if (part.volume < smallest_part)  // more does not matter
        part.volume += relative_volume(mesh, spacing, t);
      for (Tet n : mesh.neighbours[t]) {
        if (seen[n] || labels[n] != part.label) continue;
        seen[n] = 1;
        result.order.push_back(n);
      }
    }
    part.end = result.order.size();
    result.parts.push_back(part);
  }
  return result;
}

std::uint64_t remove_once(const TetMesh& mesh, const std::vector<double>& spacing, Labels& labels) {
  const Parts found = connected_parts(mesh, spacing, labels);
  const auto size = [](const Part& p) { return p.end - p.begin; };
  const Part* largest = nullptr;
  for (const Part& p : found.parts)
    if (p.label == 1 && (!largest || size(p) > size(*largest))) largest = &p;
  std::uint64_t removed = 0;
  for (const Part& p : found.parts) {
    if (p.infinite || &p == largest || p.volume >= smallest_part) continue;
    ++removed;
    for (std::size_t k = p.begin; k < p.end; ++k) labels[found.order[k]] = p.label ^ 1;
  }
  return removed;
}

}  // namespace

std::uint64_t remove_specks(const TetMesh& mesh, const std::vector<double>& spacing,
                            Labels& labels) {
  // A speck within a speck comes to light when the outer one is gone.
  std::uint64_t total = 0;
  for (std::uint64_t removed = 1; removed > 0; total += removed)
    removed = remove_once(mesh, spacing, labels);
  return total;
}

}  // namespace arris
