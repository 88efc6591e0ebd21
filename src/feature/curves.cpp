#include "feature/curves.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/vec.h"

namespace arris {
namespace {

// A line that bends by this much, and by this multiple of what it bends a step before and after,
// has a corner there.
constexpr double corner_bend = radians(50);
constexpr double corner_ratio = 2;

// A curve is convex or concave if this share of its length is.
constexpr double clear_share = 0.9;

class Tracer {
 public:
  Tracer(const Mesh& mesh, const Network& network, FeatureNetwork& result)
      : mesh_(mesh), network_(network), edges_(network.edges()), result_(result) {}

  void run() {
    find_corners();
    used_.assign(edges_.edges.size(), 0);
    std::vector<Found> found;
    for (const FeatureCorner& corner : result_.corners)
      for (Index e : edges_.at(corner.vertex))
        if (network_.has(e) && !used_[e]) found.push_back(trace(corner.vertex, e));
    for (std::size_t e = 0; e < used_.size(); ++e)  // closed curves are left
      if (network_.has(static_cast<Index>(e)) && !used_[e])
        found.push_back(trace(edges_.edges[e].ends[0], static_cast<Index>(e)));
    std::sort(found.begin(), found.end(),
              [](const Found& a, const Found& b) { return a.lowest < b.lowest; });
    for (Found& f : found) result_.curves.push_back(std::move(f.curve));
  }

 private:
  struct Found {
    FeatureCurve curve;
    Index lowest;  // mesh edge
  };

  void find_corners() {
    is_corner_.assign(mesh_.vertices.size(), 0);
    for (std::size_t k = 0; k < is_corner_.size(); ++k) {
      const auto v = static_cast<Index>(k);
      const std::uint32_t degree = network_.degree(v);
      if (degree == 0 || (degree == 2 && !bends_sharply(v))) continue;
      is_corner_[v] = 1;
      result_.corners.push_back({v, mesh_.vertices[v], degree});
    }
  }

  // Degree 2 only.
  bool bends_sharply(Index v) const {
    Index in = no_index, out = no_index;
    for (Index e : edges_.at(v))
      if (network_.has(e)) (in == no_index ? in : out) = e;
    const double bend = network_.bend(in, v, out);
    return bend >= corner_bend &&
           bend >= corner_ratio * std::max(bend_beyond(v, in), bend_beyond(v, out));
  }

  // How the line bends at the far end of edge e from v; 0 where it ends.
  double bend_beyond(Index v, Index e) const {
    const Index w = edges_.other_end(e, v), next = network_.next(w, e);
    return next == no_index ? 0 : network_.bend(e, w, next);
  }

  // The curve that leaves v along e.
  Found trace(Index v, Index e) {
    Found found{{}, e};
    FeatureCurve& curve = found.curve;
    curve.vertices.push_back(v);
    double turned = 0, ridge = 0, sharpest = 0;
    for (; e != no_index && !used_[e]; e = is_corner_[v] ? no_index : network_.next(v, e)) {
      used_[e] = 1;
      found.lowest = std::min(found.lowest, e);
      const MeshEdge& edge = edges_.edges[e];
      curve.length += edge.length;
      turned += edge.turning * edge.length;
      if (edge.turning > 0) ridge += edge.length;
      if (std::abs(edge.turning) > std::abs(sharpest)) sharpest = edge.turning;
      v = edges_.other_end(e, v);
      curve.vertices.push_back(v);
    }
    curve.closed = curve.vertices.front() == curve.vertices.back() && !is_corner_[v];
    if (curve.closed) curve.vertices.pop_back();
    const double mean = curve.length > 0 ? turned / curve.length : sharpest;
    curve.mean_angle = 180 - degrees(mean);
    curve.sharpest_angle = 180 - degrees(sharpest);
    curve.kind = ridge >= clear_share * curve.length         ? CurveKind::convex
                 : ridge <= (1 - clear_share) * curve.length ? CurveKind::concave
                                                             : CurveKind::mixed;
    return found;
  }

  const Mesh& mesh_;
  const Network& network_;
  const MeshEdges& edges_;
  FeatureNetwork& result_;
  std::vector<std::uint8_t> is_corner_, used_;
};

}  // namespace

void trace_curves(const Mesh& mesh, const Network& network, FeatureNetwork& result) {
  Tracer(mesh, network, result).run();
}

const char* name(CurveKind kind) noexcept {
  switch (kind) {
    case CurveKind::convex:
      return "convex";
    case CurveKind::concave:
      return "concave";
    case CurveKind::mixed:
      return "mixed";
  }
  return "unknown";
}

}  // namespace arris
