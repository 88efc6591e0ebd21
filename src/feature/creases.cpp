#include "feature/creases.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/angle.h"
#include "base/parallel.h"
#include "base/triangle.h"
#include "base/vec.h"
#include "feature/small_set.h"

namespace arris {
namespace {

// Hysteresis: a strong edge turns by the first angle and by the first multiple of what curvature
// and noise explain, a weak edge by the second.
constexpr double strong_angle = radians(20), weak_angle = radians(10);
constexpr double strong_ratio = 3, weak_ratio = 2;

// A clear edge turns by the first angle, which no surface does that is sampled well enough to be
// reconstructed, and by the multiple that noise and curvature reach at one edge in a hundred.
constexpr double clear_angle = radians(60), clear_ratio = 5;

// Or it lies between facets of several triangles, flat up to rounding: those of a polyhedron drawn
// with few triangles, where curvature cannot be told from the edges themselves.
constexpr double flat = radians(0.1);

// A line of edges without a clear one needs this many, so many of them strong.
constexpr std::uint32_t shortest_line = 5, least_strong = 2;

// Cosine of the largest bend of a line from one edge to the next, 53 degrees.
constexpr double sharpest_bend = 0.6;

// Where more meet no line goes on: it is the tip of a jagged fan. All pairs would be tried.
constexpr std::size_t most_creases = 64;

// How far the curvature beside an edge is measured, in mean lengths of the edges at its ends.
constexpr double reach = 2.0;

// The nearest faces suffice: two dozen are within reach where triangles are alike, but beside the
// large ones that close a hole the whole mesh may be. Measured on a one-sided scan of 24,566
// points: without a bound this took 21 s, more than all the rest.
constexpr std::size_t most_faces = 256;

// Edges nearer than this to the plane through the crease belong to the crease itself.
constexpr double crease_width = 0.25;

// A crease between flat triangles with obtuse angles can have circumcentres that coincide; it is
// taken to be at least this share of the mean edge length wide.
constexpr double least_dual = 0.5;

// The faces beside one edge, on one side.
class Side {
 public:
  Side(const Mesh& mesh, const MeshEdges& edges) : mesh_(mesh), edges_(edges) {}

  // Σ |turning| length cos² / area: how much the surface turns across lines parallel to edge e, per
  // length. An edge that turns more than e counts as if it turned as much: it may be a crease.
  // `spacing` is the mean edge length there.
  double turning_rate(Index e, Index first, double spacing) {
    place(e, first, spacing);
    double area = 0, turned = 0;
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      const Index f = faces_[k];
      area += face_area(f);
      for (Index o : edges_.of_face[f]) {
        if (o == no_index || o == e) continue;
        const MeshEdge& other = edges_.edges[o];
        const double turning = std::min(std::abs(other.turning), limit_);
        const Vec3 u = mesh_.vertices[other.ends[0]], v = mesh_.vertices[other.ends[1]];
        if (depth(0.5 * (u + v)) > crease_width * spacing && other.length > 0) {
          const double cosine = dot(v - u, along_) / other.length;
          turned += 0.5 * turning * other.length * cosine * cosine;  // half to each of its faces
        }
        visit(other.faces[other.faces[0] == f ? 1 : 0]);
      }
    }
    return area > 0 ? turned / area : 0;
  }

 private:
  void place(Index e, Index first, double spacing) {
    const MeshEdge& edge = edges_.edges[e];
    const Vec3 u = mesh_.vertices[edge.ends[0]], v = mesh_.vertices[edge.ends[1]];
    middle_ = 0.5 * (u + v);
    along_ = 1 / edge.length * (v - u);
    limit_ = std::abs(edge.turning);
    radius_ = reach * spacing + 0.5 * edge.length;
    // Away from the crease: from its middle to the face, straight across. The plane through the
    // crease halves the angle between the sides well enough.
    const Vec3 other = centroid(edge.faces[edge.faces[0] == first ? 1 : 0]);
    away_ = normalized(across(centroid(first)) - across(other));
    faces_.assign(1, first);
    seen_.clear();
    seen_.insert(first);
  }

  Vec3 across(Vec3 p) const {
    const Vec3 d = p - middle_;
    return normalized(d - dot(d, along_) * along_);
  }
  double depth(Vec3 p) const { return dot(p - middle_, away_); }
  Vec3 centroid(Index f) const { return middle_of(mesh_.vertices, mesh_.triangles[f]); }
  double face_area(Index f) const {
    const Triangle& c = mesh_.triangles[f];
    const Vec3 a = mesh_.vertices[c[0]];
    return 0.5 * length(cross(mesh_.vertices[c[1]] - a, mesh_.vertices[c[2]] - a));
  }

  void visit(Index f) {
    if (f == no_index || faces_.size() == most_faces) return;
    const Vec3 c = centroid(f);
    if (depth(c) <= 0 || distance(c, middle_) > radius_) return;
    if (seen_.insert(f)) faces_.push_back(f);
  }

  const Mesh& mesh_;
  const MeshEdges& edges_;
  Vec3 middle_, along_, away_;
  double limit_ = 0, radius_ = 0;
  std::vector<Index> faces_;
  SmallSet seen_;
};

// Per vertex the lengths of the edges there, summed.
std::vector<double> lengths_round(const MeshEdges& edges) {
  std::vector<double> sum(edges.star_begin.size() - 1, 0);
  for (const MeshEdge& edge : edges.edges)
    for (Index v : edge.ends) sum[v] += edge.length;
  return sum;
}

// Of the edges at both ends of e.
double mean_length_round(const MeshEdges& edges, const std::vector<double>& round, Index e) {
  const auto [u, v] = edges.edges[e].ends;
  return (round[u] + round[v]) / static_cast<double>(edges.at(u).size() + edges.at(v).size());
}

// Triangle f is part of a larger facet beside its edge e.
bool is_in_flat_facet(const MeshEdges& edges, Index f, Index e) {
  const auto& sides = edges.of_face[f];
  return std::any_of(sides.begin(), sides.end(), [&](Index o) {
    return o != e && o != no_index && edges.edges[o].faces[1] != no_index &&
           std::abs(edges.edges[o].turning) < flat;
  });
}

Crease judge(const MeshEdges& edges, const std::vector<double>& round, Side& side, Index e) {
  const MeshEdge& edge = edges.edges[e];
  const double turning = std::abs(edge.turning);
  if (turning < weak_angle || edge.faces[1] == no_index || edge.length == 0) return Crease::none;
  const double spacing = mean_length_round(edges, round, e);
  const double rate = std::max(side.turning_rate(e, edge.faces[0], spacing),
                               side.turning_rate(e, edge.faces[1], spacing));
  const double expected = rate * std::max(edge.dual, least_dual * spacing);
  if (turning >= clear_angle &&
      (turning >= clear_ratio * expected ||
       (is_in_flat_facet(edges, edge.faces[0], e) && is_in_flat_facet(edges, edge.faces[1], e))))
    return Crease::clear;
  if (turning >= strong_angle && turning >= strong_ratio * expected) return Crease::strong;
  return turning >= weak_ratio * expected ? Crease::weak : Crease::none;
}

// Edges e and f, which meet at v, are one line.
bool goes_on(const Mesh& mesh, const MeshEdges& edges, Index e, Index v, Index f) {
  if ((edges.edges[e].turning > 0) != (edges.edges[f].turning > 0)) return false;
  const Vec3 in = mesh.vertices[v] - mesh.vertices[edges.other_end(e, v)];
  const Vec3 out = mesh.vertices[edges.other_end(f, v)] - mesh.vertices[v];
  return dot(in, out) >= sharpest_bend * length(in) * length(out);
}

// Union-find over edges.
class Lines {
 public:
  explicit Lines(std::size_t edges) : parent_(edges) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  void join(Index a, Index b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::uint8_t> worth_keeping(const std::vector<Crease>& crease) {
    struct Tally {
      std::uint32_t all = 0, strong = 0, clear = 0;
    };
    std::vector<Tally> tally(parent_.size());
    for (std::size_t e = 0; e < crease.size(); ++e) {
      Tally& t = tally[find(static_cast<Index>(e))];
      t.all += crease[e] != Crease::none;
      t.strong += crease[e] == Crease::strong;
      t.clear += crease[e] == Crease::clear;
    }
    std::vector<std::uint8_t> keep(crease.size());
    for (std::size_t e = 0; e < crease.size(); ++e) {
      const Tally& t = tally[find(static_cast<Index>(e))];
      keep[e] = crease[e] != Crease::none &&
                (t.clear > 0 || (t.all >= shortest_line && t.strong >= least_strong));
    }
    return keep;
  }

 private:
  Index find(Index e) {
    while (parent_[e] != e) e = parent_[e] = parent_[parent_[e]];
    return e;
  }
  std::vector<Index> parent_;
};

}  // namespace

std::vector<Crease> judge_edges(const Mesh& mesh, const MeshEdges& edges, Job& job) {
  std::vector<Crease> crease(edges.edges.size(), Crease::none);
  const std::vector<double> round = lengths_round(edges);
  constexpr std::size_t grain = 4096;
  parallel_chunks(crease.size(), grain, job.threads(), [&](std::size_t begin, std::size_t end) {
    if (job.cancelled()) return;  // the next tick throws
    Side side(mesh, edges);
    for (std::size_t e = begin; e < end; ++e)
      crease[e] = judge(edges, round, side, static_cast<Index>(e));
  });
  return crease;
}

std::vector<std::uint8_t> connect_creases(const Mesh& mesh, const MeshEdges& edges,
                                          const std::vector<Crease>& crease) {
  Lines lines(crease.size());
  std::vector<Index> here;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    here.clear();
    for (Index e : edges.at(static_cast<Index>(v)))
      if (crease[e] != Crease::none) here.push_back(e);
    if (here.size() > most_creases) continue;
    for (std::size_t i = 0; i < here.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (goes_on(mesh, edges, here[i], static_cast<Index>(v), here[j]))
          lines.join(here[i], here[j]);
  }
  return lines.worth_keeping(crease);
}

}  // namespace arris
