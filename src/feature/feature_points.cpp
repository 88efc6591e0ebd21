#include "feature/feature_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <optional>

#include "base/parallel.h"
#include "cloud/nearest.h"
#include "feature/meet.h"

namespace arris {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }
double env(const char* name, double value) {
  const char* s = std::getenv(name);
  return s ? std::atof(s) : value;
}

struct Meeting {
  const std::vector<Vec3>& points;
  const FacetMesh& mesh;
  const std::vector<double>& spacing;
  const Sensed& sensed;
  double least_angle = radians(env("LEAST", 25));
  double compatible_angle = radians(env("COMPAT", 18));
  double compatible_distance = env("COMPATD", 0.1);
  double farthest = env("FAR", 1.5);
  double corner_farthest = env("CFAR", 2.5);
  double foot = env("FOOT", 0.3);

  bool agree(Index u, const LocalSurface& a, Index v, const LocalSurface& b) const {
    const double h = (spacing[u] + spacing[v]) / 2;
    return std::abs(a.distance(points[v])) <= compatible_distance * h &&
           std::abs(b.distance(points[u])) <= compatible_distance * h &&
           dot(a.normal(points[v]), b.normal(points[v])) >= std::cos(compatible_angle);
  }
  bool crossing(Index u, Index v) const {
    for (const LocalSurface& a : sensed.at(u))
      for (const LocalSurface& b : sensed.at(v))
        if (agree(u, a, v, b)) return false;
    return !sensed.at(u).empty() && !sensed.at(v).empty();
  }
};

// +1: convex edge between them, -1: concave, 0: neither.
int turn(const Meeting& m, Index u, const LocalSurface& a, Index v, const LocalSurface& b) {
  const double h = 1e-6 * m.spacing[u];
  const double av = a.distance(m.points[v]), bu = b.distance(m.points[u]);
  if (av < h && bu < h) return 1;
  if (av > -h && bu > -h) return -1;
  return 0;
}

// x lies past a third surface that cuts the edge off before.
bool cut_off(const Meeting& m, Index u, const LocalSurface& a, Index v, const LocalSurface& b,
             Vec3 x) {
  for (Index end : {u, v})
    for (Index f : m.mesh.star(end))
      for (Index w : m.mesh.facets[f]) {
        if (w == u || w == v) continue;
        for (const LocalSurface& c : m.sensed.at(w)) {
          if (m.agree(u, a, w, c) || m.agree(v, b, w, c)) continue;
          const int s = turn(m, u, a, w, c);
          if (s == 0 || s != turn(m, v, b, w, c)) continue;
          if (s * c.distance(x) > 0.05 * m.spacing[u]) return true;
        }
      }
  return false;
}

struct Candidate {
  FeaturePoint point;
  double quality;  // distance from the start: smaller is better
  int votes = 0;
};

void try_edge(const Meeting& m, Index u, const LocalSurface& a, Index v, const LocalSurface& b,
              std::vector<Candidate>& out) {
  if (turn(m, u, a, v, b) == 0) return;
  const double h = (m.spacing[u] + m.spacing[v]) / 2;
  const Vec3 middle = 0.5 * (m.points[u] + m.points[v]);
  for (const Vec3 start : {middle, m.points[u], m.points[v]}) {
    const auto x = meet(a, b, start, std::sin(m.least_angle) / 2);
    if (!x || dot(a.normal(*x), b.normal(*x)) > std::cos(m.least_angle)) continue;
    if (distance(*x, middle) > m.farthest * h) continue;
    const double near = std::min(distance(*x, m.points[u]), distance(*x, m.points[v])) / h;
    if (start != middle && near > m.foot) continue;
    if (cut_off(m, u, a, v, b, *x)) continue;
    out.push_back({{*x, h, false, {a, b}}, near});
  }
}

void edge_candidates(const Meeting& m, std::vector<Candidate>& out) {
  for (Index f = 0; f < m.mesh.facets.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index u = m.mesh.facets[f][i], v = m.mesh.facets[f][(i + 1) % 3];
      if (u > v || !m.crossing(u, v)) continue;
      for (const LocalSurface& a : m.sensed.at(u))
        for (const LocalSurface& b : m.sensed.at(v)) try_edge(m, u, a, v, b, out);
    }
}

struct Side {
  Index v;
  const LocalSurface* s;
};

// The distinct surfaces at the corners of a facet and of its neighbours.
std::vector<Side> sides_round(const Meeting& m, Index f) {
  std::vector<Index> near(m.mesh.facets[f].begin(), m.mesh.facets[f].end());
  for (Index g : m.mesh.neighbours[f])
    for (Index v : m.mesh.facets[g])
      if (std::find(near.begin(), near.end(), v) == near.end()) near.push_back(v);
  std::vector<Side> sides;
  for (Index v : near)
    for (const LocalSurface& s : m.sensed.at(v)) {
      bool known = false;
      for (const Side& k : sides) known |= m.agree(k.v, *k.s, v, s);
      if (!known) sides.push_back({v, &s});
    }
  return sides;
}

void try_corner(const Meeting& m, const Side& a, const Side& b, const Side& c, Vec3 middle, double h,
                std::vector<Candidate>& out) {
  const auto x = meet(*a.s, *b.s, *c.s, middle);
  if (!x || distance(*x, middle) > m.corner_farthest * h) return;
  const double cosine = std::cos(m.least_angle);
  for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
    if (dot(p.s->normal(*x), q.s->normal(*x)) > cosine || turn(m, p.v, *p.s, q.v, *q.s) == 0) return;
  double near = 0;
  for (const Side& k : {a, b, c}) near = std::max(near, distance(m.points[k.v], *x) / h);
  if (near > m.corner_farthest) return;
  out.push_back({{*x, h, true, {*a.s, *b.s, *c.s}}, near});
}

void corner_candidates(const Meeting& m, std::vector<Candidate>& out) {
  for (Index f = 0; f < m.mesh.facets.size(); ++f) {
    const Triangle& t = m.mesh.facets[f];
    const std::vector<Side> sides = sides_round(m, f);
    if (sides.size() < 3) continue;
    const double h = (m.spacing[t[0]] + m.spacing[t[1]] + m.spacing[t[2]]) / 3;
    const Vec3 middle = 1.0 / 3 * (m.points[t[0]] + m.points[t[1]] + m.points[t[2]]);
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (std::size_t j = i + 1; j < sides.size(); ++j)
        for (std::size_t k = j + 1; k < sides.size(); ++k)
          try_corner(m, sides[i], sides[j], sides[k], middle, h, out);
  }
}

// Corner candidates that coincide.
void vote(std::vector<Candidate>& all) {
  for (Candidate& a : all)
    if (a.point.corner)
      for (const Candidate& b : all)
        if (b.point.corner && distance(a.point.position, b.point.position) < 0.05 * a.point.spacing) ++a.votes;
}

}  // namespace

void find_feature_points(const std::vector<Vec3>& points, const FacetMesh& mesh,
                                         const std::vector<double>& spacing, const Sensed& sensed,
                                         std::vector<FeaturePoint>& kept, Job& job) {
  const Meeting m{points, mesh, spacing, sensed};
  std::vector<Candidate> candidates;
  corner_candidates(m, candidates);
  job.tick(0.5);
  edge_candidates(m, candidates);
  vote(candidates);
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    if (a.point.corner != b.point.corner) return a.point.corner;
    if (a.votes != b.votes && a.point.corner) return a.votes > b.votes;
    return a.quality < b.quality;
  });
  const double apart = env("APART", 0.4), occupied = env("OCC", 0.01);
  // Thin: a grid would do; candidates are few.
  const NearestSample nearest(points);
  std::vector<std::pair<std::array<long, 3>, Index>> grid;
  double cell = 0;
  for (const Candidate& c : candidates) cell = std::max(cell, c.point.spacing);
  cell *= apart;
  std::map<std::array<long, 3>, std::vector<Index>> cells;
  const auto key_of = [&](Vec3 x) {
    return std::array<long, 3>{std::lround(std::floor(x.x / cell)), std::lround(std::floor(x.y / cell)),
                               std::lround(std::floor(x.z / cell))};
  };
  for (Index i = 0; i < kept.size(); ++i) cells[key_of(kept[i].position)].push_back(i);
  for (const Candidate& c : candidates) {
    const Vec3 x = c.point.position;
    const double h = c.point.spacing;
    if (nearest(x).distance < occupied * h) continue;
    const auto key = key_of(x);
    bool free = true;
    for (long i = -1; i <= 1 && free; ++i)
      for (long j = -1; j <= 1 && free; ++j)
        for (long k = -1; k <= 1 && free; ++k) {
          const auto it = cells.find({key[0] + i, key[1] + j, key[2] + k});
          if (it == cells.end()) continue;
          for (Index other : it->second)
            free &= distance(kept[other].position, x) >= apart * h;
        }
    if (!free) continue;
    cells[key].push_back(static_cast<Index>(kept.size()));
    kept.push_back(c.point);
  }
}

}  // namespace arris
