#include "compare/sharp_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <tuple>

#include "base/vec.h"

namespace arris::compare {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

// The normal of a triangle less high than this is rounding noise. In diagonals.
constexpr double thinnest = 1e-6;

// A right angle between faces whose corners were rounded still counts at a threshold of 90.
constexpr double angle_slack = 0.01;  // degrees

// Two sharp edges that turn by more than this make a corner, as does the tip of a cone whose angle
// defect is larger than a right angle.
constexpr double corner_turn = std::numbers::pi / 4, tip_defect = std::numbers::pi / 2;

// One side of a triangle.
struct Side {
  Index a, b;  // a < b
  Index triangle;
  bool forward;  // the triangle walks from a to b
};

std::vector<Side> sorted_sides(const Surface& surface) {
  std::vector<Side> sides;
  sides.reserve(3 * surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = surface.triangles[t][k], b = surface.triangles[t][(k + 1) % 3];
      if (a != b) sides.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(t), a < b});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::tie(x.a, x.b, x.triangle) < std::tie(y.a, y.b, y.triangle);
  });
  return sides;
}

bool is_thin(const Surface& surface, Index triangle) {
  if (!surface.is_solid(triangle)) return true;
  const auto& [a, b, c] = surface.triangles[triangle];
  const Vec3 ab = surface.points[b] - surface.points[a];
  const Vec3 bc = surface.points[c] - surface.points[b];
  const Vec3 ca = surface.points[a] - surface.points[c];
  const double longest = std::max({length(ab), length(bc), length(ca)});
  return length(cross(ab, ca)) < thinnest * longest;
}

// The turn at an edge of two or more triangles; negative if it cannot be told.
double turn_at(const Surface& surface, std::span<const Side> edge) {
  if (edge.size() > 2) return std::numeric_limits<double>::infinity();
  if (is_thin(surface, edge[0].triangle) || is_thin(surface, edge[1].triangle)) return -1;
  const Vec3 m = surface.normals[edge[0].triangle];
  Vec3 n = surface.normals[edge[1].triangle];
  if (edge[0].forward == edge[1].forward) n = -n;  // not walked consistently
  return std::atan2(length(cross(m, n)), dot(m, n)) * degrees;
}

void add_angles(const Surface& surface, EdgeTurns& turns) {
  turns.defect.assign(surface.points.size(), 2 * std::numbers::pi);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Triangle& corners = surface.triangles[t];
    if (!surface.is_solid(static_cast<Index>(t))) {
      for (const Index v : corners) turns.uncertain[v] = 1;
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = surface.points[corners[k]];
      const Vec3 u = surface.points[corners[(k + 1) % 3]] - p;
      const Vec3 w = surface.points[corners[(k + 2) % 3]] - p;
      turns.defect[corners[k]] -= std::atan2(length(cross(u, w)), dot(u, w));
    }
  }
}

// The sharp edges that end in a vertex.
struct Fan {
  int edges = 0;
  Vec3 first, second;  // directions of two of them, away from the vertex
};

bool is_corner(const Fan& fan, double defect, bool uncertain) {
  if (fan.edges == 0) return !uncertain && defect > tip_defect;
  if (fan.edges == 2) return dot(fan.first, fan.second) > -std::cos(corner_turn);
  return fan.edges > 2;
}

}  // namespace

EdgeTurns measure_edges(const Surface& surface) {
  EdgeTurns turns;
  turns.uncertain.assign(surface.points.size(), 0);
  const std::vector<Side> sides = sorted_sides(surface);
  for (std::size_t begin = 0, end; begin < sides.size(); begin = end) {
    end = begin + 1;
    const Index a = sides[begin].a, b = sides[begin].b;
    while (end < sides.size() && sides[end].a == a && sides[end].b == b) ++end;
    const std::span<const Side> edge(&sides[begin], end - begin);
    const auto forward =
        std::count_if(edge.begin(), edge.end(), [](const Side& side) { return side.forward; });
    if (edge.size() % 2 != 0)
      ++turns.odd_edges;
    else if (2 * static_cast<std::size_t>(forward) != edge.size())
      ++turns.unbalanced_edges;
    if (edge.size() == 1)
      turns.uncertain[a] = turns.uncertain[b] = 1;
    else if (const double turn = turn_at(surface, edge); turn > 0)
      turns.edges.push_back({a, b, turn});
  }
  add_angles(surface, turns);
  return turns;
}

Features find_features(const Surface& surface, const EdgeTurns& turns, double dihedral) {
  Features found;
  std::vector<Fan> fans(surface.points.size());
  double total = 0;
  for (const auto& [a, b, turn] : turns.edges) {
    const Vec3 along = surface.points[b] - surface.points[a];
    const double size = length(along);
    if (turn < dihedral - angle_slack || !(size > 0)) continue;
    found.edges.push_back({a, b, b});
    found.length_until.push_back(total += size);
    const auto add = [&](Index v, Vec3 away) {
      Fan& fan = fans[v];
      if (fan.edges == 0) fan.first = away;
      if (fan.edges == 1) fan.second = away;
      ++fan.edges;
    };
    add(a, (1 / size) * along);
    add(b, (-1 / size) * along);
  }
  for (const Index v : surface.used)
    if (is_corner(fans[v], turns.defect[v], turns.uncertain[v] != 0))
      found.corners.push_back({v, v, v});
  return found;
}

}  // namespace arris::compare
