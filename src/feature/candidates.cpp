#include "feature/candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <span>
#include <utility>

#include "base/angle.h"
#include "base/triangle.h"
#include "feature/meet.h"
#include "feature/point_grid.h"
#include "feature/small_set.h"

namespace arris {
namespace {

// Least angle between the surfaces of a feature: 30 degrees is a sharp edge by common usage; what
// bends less keeps the bevel of its samples.
constexpr double least_angle = radians(25);
const double largest_cosine = std::cos(least_angle);
// Newton's steps go through worse conditioned places.
const double least_sine = std::sin(least_angle) / 2;
// How far from a crossing its edge or corner may lie, in units of spacing.
constexpr double edge_reach = 1.5;
constexpr double corner_reach = 2.5;
// A side longer than this (in units of spacing) spans a gap of the samples. Planes are carried on
// into it, by this share of the side: an edge of 90 degrees lies at half the side from its middle.
constexpr double gap_length = 2.5, gap_reach = 0.6;
// With more distinct sides round one facet there is no corner to be told, only noise; every three
// of them would be tried. On 76 clean clouds of 38 models there are seven at most.
constexpr std::size_t most_sides = 16;
// Feet of the ends themselves are taken for ends nearer than this to the edge.
constexpr double foot_reach = 0.3;
// From so many it is a corner for sure, and they need not all be compared with each other.
constexpr int most_votes = 256;
// How far past a third surface an edge may run, in units of spacing.
constexpr double overrun = 0.05;
// Corners found from several facets are the same within this, in units of spacing.
constexpr double same_corner = 0.05;

// The sides at a point of a facet.
template <class Body>
void for_sides(const Crossing& c, Index v, Index facet, Body&& body) {
  for (const LocalSurface& s : c.sensed.at(v)) body(Side{v, &s, facet});
}

// x lies past a third surface near u or v that cuts the edge of a and b off before.
bool is_cut_off(const Crossing& c, const Side& a, const Side& b, Vec3 x) {
  const double far = overrun * c.spacing[a.point];
  const auto cuts = [&](const Side& s) {
    if (c.agree(a, s) || c.agree(b, s)) return false;
    const Turn turn = c.turn(a, s);
    if (turn == Turn::none || turn != c.turn(b, s)) return false;
    return static_cast<int>(turn) * s.surface->distance(x) > far;
  };
  std::vector<Index> buffer;
  for (const Side& end : {a, b})
    for (Index f : c.mesh.star_near(end.point, end.facet, buffer)) {
      const Index w = next_corner(c.mesh.facets[f], end.point);
      if (w == a.point || w == b.point) continue;
      for (const LocalSurface& s : c.sensed.at(w))
        if (cuts({w, &s, f})) return true;
    }
  return false;
}

bool is_sharp(const LocalSurface& a, const LocalSurface& b, Vec3 x) {
  return dot(a.normal(x), b.normal(x)) <= largest_cosine;
}

bool all_planes(std::initializer_list<const LocalSurface*> surfaces) {
  return std::all_of(surfaces.begin(), surfaces.end(),
                     [](const LocalSurface* s) { return s->is_plane(); });
}

// The first of the points that has no more than most_round facets, else the last: what is looked
// for from the tip of a fan is looked for all round it.
Index home(const Crossing& c, std::initializer_list<Index> points) {
  Index v = no_index;
  for (Index w : points)
    if (v == no_index || c.mesh.star(v).size() > most_round) v = w;
  return v;
}

void try_edge(const Crossing& c, const Side& a, const Side& b, std::vector<Candidate>& out) {
  if (c.turn(a, b) == Turn::none) return;
  const Vec3 u = c.points[a.point], v = c.points[b.point], middle = 0.5 * (u + v);
  const double h = (c.spacing[a.point] + c.spacing[b.point]) / 2, side = distance(u, v);
  const bool gap = side > gap_length * h && all_planes({a.surface, b.surface});
  const double reach = std::max(edge_reach * h, gap ? gap_reach * side : 0);
  for (const Vec3 start : {middle, u, v}) {
    const auto x = meet(*a.surface, *b.surface, start, least_sine);
    if (!x || !is_sharp(*a.surface, *b.surface, *x)) continue;
    if (distance(*x, middle) > reach) continue;
    const double far = std::min(distance(*x, u), distance(*x, v)) / h;
    if (start != middle && far > foot_reach) continue;
    if (is_cut_off(c, a, b, *x)) continue;
    out.push_back(
        {{*x, h, false, home(c, {a.point, b.point}), no_index, {*a.surface, *b.surface}}, far});
    if (far > edge_reach) {
      out.back().point.gap = side;
      out.back().point.turn = c.turn(a, b);
    }
  }
}

// A point and the facet that led to it.
struct Seen {
  Index point, facet;
};

// A surface and the points near a facet that lie on it.
struct Face {
  Side side{};
  std::vector<Seen> points;
};

// Collects the faces round one facet after another, and keeps its memory from each to the next.
class FaceFinder {
 public:
  explicit FaceFinder(const Crossing& crossing) : c_(crossing), ring_(crossing.points.size()) {}

  // The distinct surfaces at the corners of a facet and of its neighbours, and the planes one ring
  // farther: quadrics do not hold there. Good until the next call.
  std::span<const Face> faces_round(Index f) {
    near_.clear();
    seen_.clear();
    count_ = 0;
    add_corners(f);
    for (Index g : c_.mesh.neighbours[f]) add_corners(g);
    const std::size_t inner = near_.size();
    for (std::size_t k = 0; k < inner; ++k) add_ring(near_[k]);
    for (std::size_t k = 0; k < near_.size(); ++k)
      for_sides(c_, near_[k].point, near_[k].facet, [&](const Side& s) {
        if (k < inner || s.surface->is_plane()) add(s);
      });
    return {faces_.data(), count_};
  }

 private:
  struct Run {
    Index begin = 0, size = 0;
  };
  void add_corners(Index f) {
    for (Index v : c_.mesh.facets[f])
      if (seen_.insert(v)) near_.push_back({v, f});
  }

  // The ring of a point is asked for from all facets round it, and kept. That of a point of very
  // many facets depends on where one comes from.
  void add_ring(const Seen& from) {
    if (c_.mesh.star(from.point).size() > most_round) {
      for (Index g : c_.mesh.star_near(from.point, from.facet, buffer_)) add_corners(g);
      return;
    }
    Run& ring = ring_[from.point];
    if (ring.size == 0) ring = collect_ring(from.point);
    for (Index k = ring.begin; k < ring.begin + ring.size; ++k)
      if (seen_.insert(rings_[k].point)) near_.push_back(rings_[k]);
  }

  // In the order in which the facets of its star name them.
  Run collect_ring(Index v) {
    const std::size_t begin = rings_.size();
    for (Index g : c_.mesh.star(v))
      for (Index w : c_.mesh.facets[g])
        if (w != v && std::none_of(rings_.begin() + static_cast<std::ptrdiff_t>(begin),
                                   rings_.end(), [w](const Seen& s) { return s.point == w; }))
          rings_.push_back({w, g});
    return {static_cast<Index>(begin), static_cast<Index>(rings_.size() - begin)};
  }

  void add(const Side& s) {
    const auto end = faces_.begin() + static_cast<std::ptrdiff_t>(count_);
    const auto same =
        std::find_if(faces_.begin(), end, [&](const Face& face) { return c_.agree(face.side, s); });
    if (same != end) return same->points.push_back({s.point, s.facet});
    if (count_ == faces_.size()) faces_.emplace_back();
    faces_[count_].side = s;
    faces_[count_++].points.assign(1, {s.point, s.facet});
  }

  const Crossing& c_;
  std::vector<Seen> near_;
  SmallSet seen_;
  std::vector<Index> buffer_;
  std::vector<Run> ring_;  // per point: its part of rings_, none if not yet known
  std::vector<Seen> rings_;
  std::vector<Face> faces_;  // the first count_ are in use
  std::size_t count_ = 0;
};

// Somewhere they bound an edge. Not everywhere: where a face goes round a corner by more than half
// a turn, its points are on both sides of the others.
bool bound_edge(const Crossing& c, const Face& a, const Face& b) {
  for (const Seen& u : a.points)
    for (const Seen& v : b.points)
      if (c.turn({u.point, a.side.surface}, {v.point, b.side.surface}) != Turn::none) return true;
  return false;
}

// The face as seen from its point nearest to x.
Side nearest_side(const Crossing& c, const Face& face, Vec3 x) {
  const auto nearer = [&](const Seen& u, const Seen& v) {
    return squared_length(c.points[u.point] - x) < squared_length(c.points[v.point] - x);
  };
  const Seen& nearest = *std::min_element(face.points.begin(), face.points.end(), nearer);
  return {nearest.point, face.side.surface, nearest.facet};
}

// Where a corner is looked for: round the middle of a facet.
struct Place {
  Vec3 middle;
  double h;
  double reach, gap_reach;  // lengths; the latter for planes, where the facet spans a gap
};

Place place_at(const Crossing& c, const Triangle& t) {
  const auto x = [&](std::size_t i) { return c.points[t[i]]; };
  const double h = (c.spacing[t[0]] + c.spacing[t[1]] + c.spacing[t[2]]) / 3;
  const double side = std::max({distance(x(0), x(1)), distance(x(1), x(2)), distance(x(2), x(0))});
  const double reach = corner_reach * h;
  const double far = side > gap_length * h ? std::max(reach, gap_reach * side) : reach;
  return {1.0 / 3 * (x(0) + x(1) + x(2)), h, reach, far};
}

void try_corner(const Crossing& c, const std::array<const Face*, 3>& faces, const Place& place,
                std::vector<Candidate>& out) {
  const LocalSurface &a = *faces[0]->side.surface, &b = *faces[1]->side.surface,
                     &d = *faces[2]->side.surface;
  const auto x = meet(a, b, d, place.middle);
  const double reach = all_planes({&a, &b, &d}) ? place.gap_reach : place.reach;
  if (!x || distance(*x, place.middle) > reach) return;
  std::array<Side, 3> sides;
  double far = 0;
  std::array<Turn, 3> turn;
  for (std::size_t i = 0; i < 3; ++i) {
    const Face& next = *faces[(i + 1) % 3];
    if (!is_sharp(*faces[i]->side.surface, *next.side.surface, *x)) return;
    if (!bound_edge(c, *faces[i], next)) return;
    sides[i] = nearest_side(c, *faces[i], *x);
    far = std::max(far, distance(c.points[sides[i].point], *x));
  }
  // What was sensed at a neighbouring facet of the gap is farther by as much as a side.
  const bool across = far > place.reach;
  if (far > (reach > place.reach ? reach * (1 + 1 / gap_reach) : reach)) return;
  for (std::size_t i = 0; i < 3; ++i) {
    turn[i] = c.turn(sides[i], sides[(i + 1) % 3]);
    if (is_cut_off(c, sides[i], sides[(i + 1) % 3], *x)) return;
  }
  const Index near = home(c, {sides[0].point, sides[1].point, sides[2].point});
  out.push_back({{*x, place.h, true, near, no_index, {a, b, d}}, far / place.h});
  if (!across) return;
  out.back().point.gap = reach / gap_reach;
  if (turn[0] == turn[1] && turn[1] == turn[2]) out.back().point.turn = turn[0];
}

// Points so near to a crossing side, or to a sample on a feature, that faces_round may find several
// surfaces: nowhere else can three meet.
std::vector<std::uint8_t> near_features(const Crossing& c, std::span<const CrossingSide> crossing) {
  std::vector<std::uint8_t> marked(c.points.size(), 0);
  for (Index v = 0; v < marked.size(); ++v) marked[v] = c.sensed.at(v).size() > 1;
  for (const auto& [u, v, f] : crossing) marked[u] = marked[v] = 1;
  spread(c.mesh.facets, 2, marked);
  return marked;
}

// Candidates that more others coincide with come first, then nearer ones.
void rank_corners(std::vector<Candidate>& all) {
  const auto [smallest, largest] = radii(all, same_corner);
  if (!(largest > 0)) return;
  PointGrid grid(largest, smallest);
  for (std::size_t i = 0; i < all.size(); ++i)
    grid.add(all[i].point.position, static_cast<Index>(i));
  std::vector<std::pair<int, std::size_t>> order(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    order[i] = {0, i};
    const FeaturePoint& p = all[i].point;
    grid.visit(p.position, same_corner * p.spacing, [&](Index j) {
      order[i].first += distance(all[j].point.position, p.position) <= same_corner * p.spacing;
      return order[i].first < most_votes;
    });
  }
  std::stable_sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : all[a.second].far < all[b.second].far;
  });
  std::vector<Candidate> ranked;
  ranked.reserve(all.size());
  for (const auto& [votes, i] : order) ranked.push_back(std::move(all[i]));
  all = std::move(ranked);
}

}  // namespace

std::array<double, 2> radii(const std::vector<Candidate>& candidates, double share) {
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  for (const Candidate& c : candidates) {
    smallest = std::min(smallest, share * c.point.spacing);
    largest = std::max(largest, share * c.point.spacing);
  }
  return {smallest, largest};
}

std::vector<Candidate> edge_candidates(const Crossing& c, std::span<const CrossingSide> crossing,
                                       Job& job) {
  std::vector<Candidate> found;
  for (std::size_t k = 0; k < crossing.size(); ++k) {
    if (k % 65536 == 0) job.tick(0);
    const auto [u, v, f] = crossing[k];
    for (const LocalSurface& a : c.sensed.at(u))
      for (const LocalSurface& b : c.sensed.at(v)) try_edge(c, {u, &a, f}, {v, &b, f}, found);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.far < b.far; });
  return found;
}

std::vector<Candidate> corner_candidates(const Crossing& c, std::span<const CrossingSide> crossing,
                                         Job& job) {
  std::vector<Candidate> found;
  const std::vector<std::uint8_t> near = near_features(c, crossing);
  FaceFinder finder(c);
  for (Index f = 0; f < c.mesh.facets.size(); ++f) {
    if (f % 4096 == 0) job.tick(0);
    const Triangle& t = c.mesh.facets[f];
    if (!near[t[0]] && !near[t[1]] && !near[t[2]]) continue;
    if (c.sensed.at(t[0]).empty() && c.sensed.at(t[1]).empty()) continue;
    const std::span<const Face> faces = finder.faces_round(f);
    if (faces.size() > most_sides) continue;
    const Place place = place_at(c, t);
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t j = i + 1; j < faces.size(); ++j)
        for (std::size_t k = j + 1; k < faces.size(); ++k)
          try_corner(c, {&faces[i], &faces[j], &faces[k]}, place, found);
  }
  rank_corners(found);
  return found;
}

}  // namespace arris
