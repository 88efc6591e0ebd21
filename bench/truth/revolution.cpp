#include "truth/revolution.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace arris::truth {
namespace {

constexpr double pi = std::numbers::pi;

void add_ring(Mesh& mesh, ProfilePoint p, int around) {
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * pi * i / around;
    mesh.vertices.push_back({p.radius * std::cos(angle), p.radius * std::sin(angle), p.height});
  }
}

// The strip between the rings that start at vertices `low` and `high`.
void add_strip(Mesh& mesh, Index low, Index high, Index around) {
  for (Index i = 0; i < around; ++i) {
    const Index j = (i + 1) % around;
    mesh.triangles.push_back({low + i, low + j, high + j});
    mesh.triangles.push_back({low + i, high + j, high + i});
  }
}

}  // namespace

std::vector<ProfilePoint> arc(double centre_radius, double centre_height, double r, double from,
                              double to, int segments) {
  std::vector<ProfilePoint> points;
  for (int i = 0; i <= segments; ++i) {
    const double angle = from + (to - from) * i / segments;
    points.push_back({centre_radius + r * std::cos(angle), centre_height + r * std::sin(angle)});
  }
  return points;
}

Mesh revolve(const std::vector<ProfilePoint>& profile, int around) {
  Mesh mesh;
  const Index n = static_cast<Index>(around);
  const Index rings = static_cast<Index>(profile.size()) - 2;
  for (std::size_t i = 1; i + 1 < profile.size(); ++i) add_ring(mesh, profile[i], around);
  for (Index ring = 0; ring + 1 < rings; ++ring) add_strip(mesh, ring * n, (ring + 1) * n, n);

  const Index bottom = rings * n, top = bottom + 1, last = (rings - 1) * n;
  mesh.vertices.push_back({0, 0, profile.front().height});
  mesh.vertices.push_back({0, 0, profile.back().height});
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    mesh.triangles.push_back({bottom, j, i});
    mesh.triangles.push_back({top, last + i, last + j});
  }
  return mesh;
}

Mesh revolve_loop(const std::vector<ProfilePoint>& profile, int around) {
  Mesh mesh;
  const Index n = static_cast<Index>(around);
  const Index rings = static_cast<Index>(profile.size()) - 1;
  for (Index ring = 0; ring < rings; ++ring) add_ring(mesh, profile[ring], around);
  for (Index ring = 0; ring < rings; ++ring) add_strip(mesh, ring * n, (ring + 1) % rings * n, n);
  return mesh;
}

Mesh turned_about_z(Mesh mesh, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Vec3& p : mesh.vertices) p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
  return mesh;
}

}  // namespace arris::truth
