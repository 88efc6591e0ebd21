#include "feature/refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "base/angle.h"
#include "base/distinct.h"
#include "base/parallel.h"
#include "base/triangle.h"
#include "base/vec.h"
#include "cloud/nearest.h"
#include "feature/find_features.h"
#include "feature/jet.h"
#include "feature/mesh_edges.h"
#include "feature/small_set.h"

namespace arris {
namespace {

// The sag of an edge is the height of the surface over its middle.
// An edge whose sag, by the normals at its ends, is below this part of the least is not looked at.
constexpr double straight = 0.25;
// More of it, in lengths of the edge, no smooth arc has: a semicircle has half.
constexpr double most_sag = 0.3;
// A sag s is believed by the part s² / (s² + doubt r²), r the residual of the fit: Wiener's filter
// with s² for the signal. Values of 0.1 to 1 bring the same within a few percent.
constexpr double doubt = 0.5;
// Near features a residual above this part of the edge may be an edge that was missed: rounding it
// costs more than a sag below twice the residual brings.
constexpr double coarse_residual = 0.03, sure = 2;

// Members of a fit: ten coefficients and as many again to judge them; within so many edge lengths,
// on facets that lean less than this from those at the edge.
constexpr std::size_t most_members = 24, least_members = 12;
constexpr double reach = 3;
const double least_cosine = std::cos(radians(60));

// An edge that turns by more is taken for a feature, whether it is part of a line or not; but for
// the edges of needles (height over longest side), which turn by chance.
constexpr double largest_turning = radians(45);
constexpr double needle_height = 0.15;
// Least sine of the angle at which two surfaces meet in a line.
constexpr double least_sine = 0.25;
// New points looked at near an edge that must not be entered.
constexpr std::size_t most_near = 8;
constexpr std::size_t grain = 1024;

double believe(double sag, double residual) {
  const double signal = sag * sag;
  return signal > 0 ? sag * signal / (signal + doubt * residual * residual) : 0;
}

// The points of the facets round an edge, and what it takes to walk there; kept from edge to edge.
struct Members {
  std::vector<Index> points;
  bool at_feature = false;  // the patch ends at one
  SmallSet points_seen, facets_seen;
  std::vector<std::pair<double, Index>> frontier;  // a heap, nearest first
};

// What is over the middle of one edge.
struct Lift {
  RefinePoint point;
  bool wanted = false;
};

class Refiner {
 public:
  Refiner(const Mesh& mesh, const std::vector<double>& spacing, double roughness,
          const RefineWish& wish, const MeshEdges& edges, const Network& network)
      : mesh_(mesh),
        spacing_(spacing),
        roughness_(roughness),
        wish_(wish),
        edges_(edges),
        normals_(stable_normals(mesh, edges)) {
    for (Index e = 0; e < edges.edges.size(); ++e)
      is_feature_.push_back(network.has(e) || turns_sharply(edges.edges[e]));
    measure_vertices();
  }

  bool is_feature(Index e) const { return is_feature_[e] != 0; }

  bool is_short(Index e) const { return edges_.edges[e].length < wish_.shortest * mean_spacing(e); }

  // The normals at the ends say that the arc over the edge is far lower than a sag that counts.
  // They say nothing at features.
  bool is_straight(Index e) const {
    const auto [a, b] = edges_.edges[e].ends;
    const Vec3 na = vertex_normals_[a], nb = vertex_normals_[b];
    if (squared_length(na) == 0 || squared_length(nb) == 0) return false;
    const double sag = std::abs(dot(nb - na, mesh_.vertices[b] - mesh_.vertices[a])) / 8;
    return sag < straight * wish_.least_sag * mean_spacing(e);
  }

  // Nothing if the surface cannot be told there, or the edge is short; on features always a point.
  std::optional<Lift> lift(Index e, Members& members) const {
    if (is_feature(e)) return lift_feature(e, members);
    const MeshEdge& edge = edges_.edges[e];
    if (is_short(e)) return std::nullopt;
    const auto side = sense(e, edge.faces, members);
    if (!side) return std::nullopt;
    Lift lift = at_middle(e);
    lift.point.normals = {side->normal};
    if (!raise(side->sag * side->normal, e, lift)) return std::nullopt;
    return lift;
  }

 private:
  struct Side {
    double sag;
    Vec3 normal;
  };

  Lift at_middle(Index e) const {
    const auto [a, b] = edges_.edges[e].ends;
    const Vec3 middle = 0.5 * (mesh_.vertices[a] + mesh_.vertices[b]);
    return {{middle, middle, 0.5 * mean_spacing(e), a, {}}};
  }

  double mean_spacing(Index e) const {
    const auto [a, b] = edges_.edges[e].ends;
    return (spacing_[a] + spacing_[b]) / 2;
  }

  bool turns_sharply(const MeshEdge& e) const {
    return std::abs(e.turning) > largest_turning && !is_needle(e.faces[0]) &&
           !is_needle(e.faces[1]);
  }

  void measure_vertices() {
    vertex_normals_.resize(mesh_.vertices.size());
    for (Index f = 0; f < normals_.size(); ++f)
      for (Index v : mesh_.triangles[f])
        vertex_normals_[v] = vertex_normals_[v] + area(f) * normals_[f];
    for (Vec3& n : vertex_normals_) n = normalized(n);
    for (Index e = 0; e < is_feature_.size(); ++e)
      if (is_feature_[e])
        for (Index v : edges_.edges[e].ends) vertex_normals_[v] = Vec3{};
  }

  // False if no smooth arc rises as far.
  bool raise(Vec3 by, Index e, Lift& lift) const {
    const double sag = length(by);
    if (sag > most_sag * edges_.edges[e].length) return false;
    lift.point.position = lift.point.foot + by;
    lift.wanted = !is_short(e) && sag >= wish_.least_sag * mean_spacing(e) + 2 * roughness_;
    return true;
  }

  // The surfaces of both sides, to first order, and the plane across the edge meet in the point.
  Lift lift_feature(Index e, Members& members) const {
    const MeshEdge& edge = edges_.edges[e];
    Lift lift = at_middle(e);
    lift.point.normals = {normals_[edge.faces[0]], normals_[edge.faces[1]]};
    const std::span<const Index> faces = edge.faces;
    const auto a = sense(e, faces.first(1), members), b = sense(e, faces.last(1), members);
    if (!a || !b) return lift;
    const Vec3 along = cross(a->normal, b->normal);
    const double squared_sine = squared_length(along);
    if (squared_sine < least_sine * least_sine) return lift;
    lift.point.normals = {a->normal, b->normal};
    raise(
        (1 / squared_sine) * (a->sag * cross(b->normal, along) + b->sag * cross(along, a->normal)),
        e, lift);
    return lift;
  }

  // The surface that the facets `seeds` at edge e lie on: nothing if it cannot be told. Its sag is
  // taken between its own heights at the ends, so that the point bears the same errors as they do.
  std::optional<Side> sense(Index e, std::span<const Index> seeds, Members& members) const {
    const MeshEdge& edge = edges_.edges[e];
    const Vec3 a = mesh_.vertices[edge.ends[0]], b = mesh_.vertices[edge.ends[1]];
    const Vec3 middle = 0.5 * (a + b);
    Vec3 n;
    for (Index f : seeds) n = n + normals_[f];
    if (!(squared_length(n) > 0)) return std::nullopt;
    n = normalized(n);
    const double unit = std::max(edge.length, mean_spacing(e));
    gather(seeds, middle, n, reach * unit, members);
    if (members.points.size() < least_members) return std::nullopt;
    const Jet jet = fit_jet(mesh_.vertices, members.points, middle, n, unit);
    const double sag = jet.height(middle) - (jet.height(a) + jet.height(b)) / 2;
    const bool coarse = members.at_feature && jet.residual > coarse_residual * unit;
    if (coarse && std::abs(sag) < sure * jet.residual) return Side{0, jet.normal()};
    return Side{believe(sag, jet.residual) * dot(jet.normal(), n), jet.normal()};
  }

  // The points of the facets nearest to `middle`, from the seeds on and across no feature.
  void gather(std::span<const Index> seeds, Vec3 middle, Vec3 n, double radius,
              Members& members) const {
    auto& frontier = members.frontier;
    const auto later = std::greater<>{};
    members.points.clear();
    members.points_seen.clear();
    members.facets_seen.clear();
    members.at_feature = false;
    frontier.clear();
    for (Index f : seeds)
      if (members.facets_seen.insert(f)) frontier.emplace_back(0, f);
    while (!frontier.empty() && members.points.size() < most_members) {
      std::pop_heap(frontier.begin(), frontier.end(), later);
      const Index f = frontier.back().second;
      frontier.pop_back();
      for (Index v : mesh_.triangles[f])
        if (members.points_seen.insert(v) && distance(mesh_.vertices[v], middle) < radius)
          members.points.push_back(v);
      for (Index e : edges_.of_face[f]) {
        if (is_feature_[e]) {
          members.at_feature = true;
          continue;
        }
        const auto& faces = edges_.edges[e].faces;
        const Index g = faces[0] == f ? faces[1] : faces[0];
        if (!members.facets_seen.insert(g)) continue;
        const double far = distance(centroid(g), middle);
        if (!(far < radius) || dot(normals_[g], n) < least_cosine) continue;
        frontier.emplace_back(far, g);
        std::push_heap(frontier.begin(), frontier.end(), later);
      }
    }
  }

  std::array<Vec3, 3> corners(Index f) const {
    const Triangle& t = mesh_.triangles[f];
    return {mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]};
  }

  Vec3 centroid(Index f) const { return middle_of(mesh_.vertices, mesh_.triangles[f]); }

  double area(Index f) const {
    const auto [a, b, c] = corners(f);
    return length(cross(b - a, c - a)) / 2;
  }

  bool is_needle(Index f) const {
    const auto [a, b, c] = corners(f);
    const double longest =
        std::max({squared_length(b - a), squared_length(c - b), squared_length(a - c)});
    return length(cross(b - a, c - a)) < needle_height * longest;
  }

  const Mesh& mesh_;
  const std::vector<double>& spacing_;
  double roughness_;
  RefineWish wish_;
  const MeshEdges& edges_;
  std::vector<Vec3> normals_;             // per facet
  std::vector<std::uint8_t> is_feature_;  // per edge
  std::vector<Vec3> vertex_normals_;      // unit; 0 on features
};

using Lifts = std::vector<std::unique_ptr<Lift>>;  // per edge: few have one

void lift_edge(const Refiner& refiner, Index e, Members& members, Lifts& lifts) {
  std::optional<Lift> lift = refiner.lift(e, members);
  lifts[e] = lift ? std::make_unique<Lift>(std::move(*lift)) : nullptr;
}

// Lifts those of `chosen`.
void lift_edges(const Refiner& refiner, const std::vector<Index>& chosen, Lifts& lifts, Job& job) {
  parallel_chunks(chosen.size(), grain, job.threads(), [&](std::size_t begin, std::size_t end) {
    if (job.cancelled()) return;
    Members members;
    for (std::size_t k = begin; k < end; ++k) lift_edge(refiner, chosen[k], members, lifts);
  });
}

// Facets that are to be split at two sides are split at the third as well, so that the new vertices
// lie as evenly as the old ones: on a cylinder the sides along it have no sag.
void complete_facets(const MeshEdges& edges, const Refiner& refiner, Lifts& lifts, Job& job) {
  std::vector<Index> third;
  for (const auto& sides : edges.of_face) {
    const auto wanted = [&](Index e) { return lifts[e] && lifts[e]->wanted; };
    if (std::count_if(sides.begin(), sides.end(), wanted) != 2) continue;
    third.push_back(*std::find_if_not(sides.begin(), sides.end(), wanted));
  }
  keep_distinct(third);
  std::vector<Index> missing;
  std::copy_if(third.begin(), third.end(), std::back_inserter(missing),
               [&](Index e) { return !lifts[e] && refiner.is_straight(e); });
  lift_edges(refiner, missing, lifts, job);
  for (Index e : third)
    if (lifts[e]) lifts[e]->wanted = true;
}

// Halves the edges of features that new points of smooth surface enter the diametral ball of, and
// takes back the points that enter the balls of the halves.
void protect_features(const Mesh& mesh, const MeshEdges& edges, const Refiner& refiner,
                      Lifts& lifts) {
  Members members;
  std::vector<Vec3> smooth;
  std::vector<Index> edge_of;
  for (Index e = 0; e < lifts.size(); ++e)
    if (lifts[e] && lifts[e]->wanted && !refiner.is_feature(e)) {
      smooth.push_back(lifts[e]->point.position);
      edge_of.push_back(e);
    }
  if (smooth.empty()) return;
  const NearestSample nearest(smooth);
  std::vector<NearestSample::Hit> hits;
  for (Index e = 0; e < lifts.size(); ++e) {
    if (!refiner.is_feature(e)) continue;
    const MeshEdge& edge = edges.edges[e];
    const Vec3 middle = 0.5 * (mesh.vertices[edge.ends[0]] + mesh.vertices[edge.ends[1]]);
    const bool is_entered = nearest(middle).distance < edge.length / 2;
    if (is_entered && !lifts[e]) lift_edge(refiner, e, members, lifts);
    if (!lifts[e]) continue;
    Lift& lift = *lifts[e];
    lift.wanted = lift.wanted || is_entered;
    if (!lift.wanted) continue;
    for (Index end : edge.ends) {
      const Vec3 a = lift.point.position, b = mesh.vertices[end];
      nearest.nearest(0.5 * (a + b), most_near, hits);
      for (const auto& hit : hits)
        if (hit.distance < distance(a, b) / 2) lifts[edge_of[hit.index]].reset();
    }
  }
}

}  // namespace

std::vector<RefinePoint> refine_points(const Mesh& mesh, const std::vector<double>& spacing,
                                       double roughness, const RefineWish& wish, Job& job) {
  const MeshEdges edges = collect_edges(mesh, job);
  const Network network = crease_network(mesh, edges, job);
  const Refiner refiner(mesh, spacing, roughness, wish, edges, network);
  Lifts lifts(edges.edges.size());
  std::vector<Index> curved;
  for (Index e = 0; e < lifts.size(); ++e)
    if (!refiner.is_short(e) && !refiner.is_straight(e)) curved.push_back(e);
  lift_edges(refiner, curved, lifts, job);
  job.tick(1);
  complete_facets(edges, refiner, lifts, job);
  protect_features(mesh, edges, refiner, lifts);
  std::vector<RefinePoint> points;
  for (auto& lift : lifts)
    if (lift && lift->wanted) points.push_back(std::move(lift->point));
  return points;
}

}  // namespace arris
