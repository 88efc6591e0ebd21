#include "viewer/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace arris::viewer {
namespace {

// What is nearer than a line by less than this, in radii of the model, does not hide it: the
// surface that the line bounds would, by rounding.
constexpr double depth_tolerance = 2e-3;

struct EdgeUse {
  Index a, b;  // a < b
  Index triangle;
  bool forward;
};

std::vector<EdgeUse> sorted_uses(const Model& model) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * model.triangles.size());
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const Triangle& corners = model.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = corners[i], to = corners[(i + 1) % 3];
      uses.push_back({std::min(from, to), std::max(from, to), static_cast<Index>(t), from < to});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& l, const EdgeUse& r) {
    return std::array{l.a, l.b, l.triangle} < std::array{r.a, r.b, r.triangle};
  });
  return uses;
}

Vec3 normal(const Model& model, Index triangle) {
  const Triangle& t = model.triangles[triangle];
  const Vec3 a = model.vertices[t[0]];
  return cross(model.vertices[t[1]] - a, model.vertices[t[2]] - a);
}

// The kind of an edge of two triangles.
LineKind kind_between(const Model& model, const EdgeUse& one, const EdgeUse& other, double angle,
                      Vec3 eye) {
  const Vec3 n = normal(model, one.triangle);
  Vec3 m = normal(model, other.triangle);
  if (one.forward == other.forward) m = -1.0 * m;  // misoriented
  const double turn = std::atan2(length(cross(n, m)), dot(n, m));
  if (turn > angle) return LineKind::sharp;
  const Vec3 to_eye = eye - model.vertices[one.a];
  return dot(n, to_eye) * dot(m, to_eye) < 0 ? LineKind::contour : LineKind::smooth;
}

}  // namespace

std::vector<Line> classify_edges(const Model& model, double angle, Vec3 eye) {
  const std::vector<EdgeUse> uses = sorted_uses(model);
  std::vector<Line> lines;
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    const EdgeUse& first = uses[begin];
    while (end < uses.size() && uses[end].a == first.a && uses[end].b == first.b) ++end;
    LineKind kind = LineKind::sharp;  // also if there are three triangles or more
    if (end - begin == 1)
      kind = LineKind::boundary;
    else if (end - begin == 2)
      kind = kind_between(model, first, uses[begin + 1], angle, eye);
    lines.push_back({model.vertices[first.a], model.vertices[first.b], kind});
  }
  return lines;
}

void draw_visible(const Line& line, const RayScene& scene, const Camera& camera, double pen,
                  Ink& ink) {
  const Pixel a = camera.project(line.a), b = camera.project(line.b);
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::hypot(b.x - a.x, b.y - a.y))));
  const auto along = [&](double t) { return line.a + (t / pieces) * (line.b - line.a); };
  const auto hidden = [&](int piece) {
    const Vec3 middle = along(piece + 0.5), to_line = middle - camera.eye();
    return !ink.touches(camera.project(middle), pen + 1) ||
           scene.blocked({camera.eye(), normalized(to_line)}, length(to_line) - depth_tolerance);
  };
  // Runs of visible pieces are one stroke.
  for (int begin = 0; begin < pieces; ++begin) {
    if (hidden(begin)) continue;
    int end = begin + 1;
    while (end < pieces && !hidden(end)) ++end;
    ink.stroke(camera.project(along(begin)), camera.project(along(end)), pen);
    begin = end;
  }
}

}  // namespace arris::viewer
