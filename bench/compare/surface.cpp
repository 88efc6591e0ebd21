#include "compare/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/failure.h"
#include "base/parallel.h"
#include "base/vec.h"

namespace arris::compare {
namespace {

// Beyond it squares of lengths leave the range of doubles.
constexpr double largest_coordinate = 1e150;

bool in_range(Vec3 p) {
  const auto is = [](double c) { return std::abs(c) <= largest_coordinate; };  // not if it is NaN
  return is(p.x) && is(p.y) && is(p.z);
}

std::vector<Index> used_vertices(const Mesh& mesh) {
  std::vector<bool> named(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles)
    for (const Index v : t) named[v] = true;
  std::vector<Index> used;
  for (std::size_t v = 0; v < named.size(); ++v)
    if (named[v]) used.push_back(static_cast<Index>(v));
  return used;
}

void throw_if_flat(bool flat, const std::string& name) {
  if (flat)
    throw Failure(ErrorCode::degenerate, "no triangle of the " + name + " has an area",
                  "give a mesh with a surface");
}

}  // namespace

Vec3 UnitFrame::map(Vec3 p) const {
  const Vec3 d = p - centre;
  return {d.x / diagonal, d.y / diagonal, d.z / diagonal};
}

void require_surface(const Mesh& mesh, const std::string& name) {
  if (mesh.triangles.empty())
    throw Failure(ErrorCode::bad_points, "the " + name + " has no triangles",
                  "give a mesh; points alone cannot be compared");
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const Index v : mesh.triangles[t]) {
      if (v >= mesh.vertices.size())
        throw Failure(ErrorCode::unreadable,
                      "triangle " + std::to_string(t) + " of the " + name + " names vertex " +
                          std::to_string(v) + " of " + std::to_string(mesh.vertices.size()),
                      "repair the mesh");
      if (!in_range(mesh.vertices[v]))
        throw Failure(ErrorCode::bad_points,
                      "vertex " + std::to_string(v) + " of the " + name +
                          " has a coordinate that is not a finite number, or beyond 1e150",
                      "repair the mesh");
    }
}

UnitFrame unit_frame(const Mesh& mesh, const std::string& name) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 lo{infinity, infinity, infinity}, hi = -lo;
  for (const Triangle& t : mesh.triangles)
    for (const Index v : t) {
      const Vec3 p = mesh.vertices[v];
      lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
      hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
  const double diagonal = std::hypot(hi.x - lo.x, hi.y - lo.y, hi.z - lo.z);
  throw_if_flat(!(diagonal > 0), name);
  return {0.5 * (lo + hi), diagonal};
}

std::size_t Surface::solid_at(double share) const {
  const auto at = std::upper_bound(area_until.begin(), area_until.end(), share * area());
  return std::min(static_cast<std::size_t>(at - area_until.begin()), solid.size() - 1);
}

Surface make_surface(const Mesh& mesh, const UnitFrame& frame, const std::string& name,
                     unsigned threads) {
  Surface s;
  s.triangles = mesh.triangles;
  s.used = used_vertices(mesh);
  s.points.resize(mesh.vertices.size());  // unused ones stay at the origin, whatever they were
  parallel_for(s.used.size(), threads,
               [&](std::size_t i) { s.points[s.used[i]] = frame.map(mesh.vertices[s.used[i]]); });
  if (!std::all_of(s.points.begin(), s.points.end(), in_range))
    throw Failure(ErrorCode::bad_points, "the result lies further from the truth than 1e150 of it",
                  "give both meshes in the same unit and place");
  const auto n = s.triangles.size();
  s.normals.resize(n);
  std::vector<double> area(n);
  parallel_for(n, threads, [&](std::size_t t) {
    const auto& [a, b, c] = s.triangles[t];
    const Vec3 normal = cross(s.points[b] - s.points[a], s.points[c] - s.points[a]);
    const double size = length(normal);
    if (!(size > 0) || a == b || b == c || c == a) return;
    s.normals[t] = (1 / size) * normal;
    area[t] = size / 2;
  });
  double total = 0;
  for (std::size_t t = 0; t < n; ++t)
    if (s.is_solid(static_cast<Index>(t))) {
      s.solid.push_back(static_cast<Index>(t));
      s.area_until.push_back(total += area[t]);
    }
  throw_if_flat(s.solid.empty(), name);
  s.tree = std::make_unique<NearestElement>(s.points, s.triangles, s.solid, threads);
  return s;
}

}  // namespace arris::compare
