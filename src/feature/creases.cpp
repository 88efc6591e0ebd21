#include "feature/creases.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/parallel.h"
#include "base/vec.h"

namespace arris {
namespace {

constexpr double degree = std::numbers::pi / 180;

// Hysteresis: a strong edge turns by the first angle and by the first multiple of what curvature
// and noise explain, a weak edge by the second.
constexpr double strong_angle = 20 * degree, weak_angle = 10 * degree;
constexpr double strong_ratio = 2.5, weak_ratio = 1.5;

// No surface sampled well enough to be reconstructed turns by this much at an edge.
constexpr double certain_angle = 60 * degree;

// How far the curvature beside an edge is measured, in mean lengths of the edges at its ends.
constexpr double reach = 2.0;

// Edges nearer than this to the plane through the crease belong to the crease itself.
constexpr double crease_width = 0.25;

// Edges that turn by this multiple of the edge in question are other creases, not curvature.
constexpr double other_crease = 2.0;

// A crease between flat triangles with obtuse angles can have circumcentres that coincide; it is
// taken to be at least this share of the mean edge length wide.
constexpr double least_dual = 0.5;

// The faces beside one edge, on one side.
class Side {
 public:
  Side(const Mesh& mesh, const MeshEdges& edges) : mesh_(mesh), edges_(edges) {}

  // Σ |turning| length cos² / area: how much the surface turns across lines parallel to edge e, per
  // length. `spacing` is the mean edge length there.
  double turning_rate(Index e, Index first, double spacing) {
    place(e, first, spacing);
    double area = 0, turned = 0;
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      const Index f = faces_[k];
      area += face_area(f);
      for (Index o : edges_.of_face[f]) {
        if (o == no_index || o == e) continue;
        const MeshEdge& other = edges_.edges[o];
        const double turning = std::abs(other.turning);
        if (turning > other_crease * limit_) continue;
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
    Vec3 away = across(centroid(first)) - across(other);
    const double l = length(away);
    away_ = l > 0 ? 1 / l * away : Vec3{};
    faces_.assign(1, first);
  }

  Vec3 across(Vec3 p) const {
    const Vec3 d = p - middle_;
    const Vec3 r = d - dot(d, along_) * along_;
    const double l = length(r);
    return l > 0 ? 1 / l * r : Vec3{};
  }
  double depth(Vec3 p) const { return dot(p - middle_, away_); }
  Vec3 centroid(Index f) const {
    const Triangle& c = mesh_.triangles[f];
    return 1.0 / 3 * (mesh_.vertices[c[0]] + mesh_.vertices[c[1]] + mesh_.vertices[c[2]]);
  }
  double face_area(Index f) const {
    const Triangle& c = mesh_.triangles[f];
    const Vec3 a = mesh_.vertices[c[0]];
    return 0.5 * length(cross(mesh_.vertices[c[1]] - a, mesh_.vertices[c[2]] - a));
  }

  void visit(Index f) {
    if (f == no_index) return;
    const Vec3 c = centroid(f);
    if (depth(c) <= 0 || distance(c, middle_) > radius_) return;
    if (std::find(faces_.begin(), faces_.end(), f) == faces_.end()) faces_.push_back(f);
  }

  const Mesh& mesh_;
  const MeshEdges& edges_;
  Vec3 middle_, along_, away_;
  double limit_ = 0, radius_ = 0;
  std::vector<Index> faces_;
};

double mean_length_round(const MeshEdges& edges, Index e) {
  double sum = 0;
  std::size_t count = 0;
  for (Index v : edges.edges[e].ends)
    for (Index o : edges.at(v)) {
      sum += edges.edges[o].length;
      ++count;
    }
  return sum / static_cast<double>(count);
}

Crease judge(const MeshEdges& edges, Side& side, Index e) {
  const MeshEdge& edge = edges.edges[e];
  const double turning = std::abs(edge.turning);
  if (turning < weak_angle || edge.faces[1] == no_index || edge.length == 0) return Crease::none;
  if (turning >= certain_angle) return Crease::strong;
  const double spacing = mean_length_round(edges, e);
  const double rate = std::max(side.turning_rate(e, edge.faces[0], spacing),
                               side.turning_rate(e, edge.faces[1], spacing));
  const double expected = rate * std::max(edge.dual, least_dual * spacing);
  if (turning >= strong_angle && turning >= strong_ratio * expected) return Crease::strong;
  return turning >= weak_ratio * expected ? Crease::weak : Crease::none;
}

}  // namespace

std::vector<Crease> judge_edges(const Mesh& mesh, const MeshEdges& edges, Job& job) {
  std::vector<Crease> crease(edges.edges.size(), Crease::none);
  constexpr std::size_t grain = 4096;
  parallel_chunks(crease.size(), grain, job.threads(), [&](std::size_t begin, std::size_t end) {
    Side side(mesh, edges);
    for (std::size_t e = begin; e < end; ++e) crease[e] = judge(edges, side, static_cast<Index>(e));
  });
  return crease;
}

std::vector<std::uint8_t> connect_creases(const MeshEdges& edges, const std::vector<Crease>& crease,
                                          std::size_t vertices) {
  std::vector<std::uint8_t> chosen(edges.edges.size(), 0), reached(vertices, 0);
  std::vector<Index> stack;
  const auto choose = [&](Index e) {
    if (chosen[e]) return;
    chosen[e] = 1;
    for (Index v : edges.edges[e].ends)
      if (!reached[v]) {
        reached[v] = 1;
        stack.push_back(v);
      }
  };
  for (std::size_t e = 0; e < crease.size(); ++e)
    if (crease[e] == Crease::strong) choose(static_cast<Index>(e));
  while (!stack.empty()) {
    const Index v = stack.back();
    stack.pop_back();
    for (Index e : edges.at(v))
      if (crease[e] == Crease::weak) choose(e);
  }
  return chosen;
}

}  // namespace arris
