#include "feature/settle.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "base/vec.h"
#include "feature/normal_filter.h"
#include "feature/small_set.h"

namespace arris {
namespace {

// Who has a say in where a sample goes: weights fall off with the distance, in units of spacing, as
// a Gaussian of this width, cut off at twice that. Wider ones lie less in noise, but bend down
// towards edges, where normals of the first surface do.
constexpr double say_width = 2.5, say_reach = 5;
// And with the unlikeness of normals, in units of the likeness of the filter, cut off at twice
// that. Wider than in the filter: on a cylinder the normals of a piece differ.
constexpr double unlikeness = 1.5;
// And with the distance from the surface: none at so many deviations of the noise.
constexpr double gate = 4;
// Samples move all at once; after three times they hardly do.
constexpr int passes = 3;
constexpr std::size_t grain = 1024;  // samples a chunk

// exp(-x²/2) of the length x of `difference` in units of `width`.
double falloff(Vec3 difference, double width) {
  return std::exp(-squared_length(difference) / (2 * width * width));
}

// What is known of the piece a sample is on.
struct Piece {
  Vec3 normal;       // zero if none
  double width = 0;  // of unlikeness, as a chord
};

// The piece that takes most of the star of v.
Piece find_piece(const std::vector<Vec3>& points, const FacetMesh& mesh,
                 const FilteredNormals& filtered, Index v) {
  Piece piece;
  for (Index f : mesh.star(v)) {
    const double width = unlikeness * filtered.likeness[f];
    piece.width = piece.width > 0 ? std::min(piece.width, width) : width;
  }
  double most = 0;
  for (Index f : mesh.star(v)) {
    Vec3 sum{};
    double all = 0;
    for (Index g : mesh.star(v)) {
      const double weight = angle_at(points, mesh.facets[g], v) *
                            falloff(filtered.normal[f] - filtered.normal[g], piece.width);
      sum = sum + weight * filtered.normal[g];
      all += weight;
    }
    if (all <= most || sum == Vec3{}) continue;
    most = all;
    piece.normal = 1 / length(sum) * sum;
  }
  return piece;
}

// Walks over the mesh from a sample as far as its piece goes.
class Walk {
 public:
  Walk(const FacetMesh& mesh, const std::vector<Piece>& pieces) : mesh_(mesh), pieces_(pieces) {}

  // The points of the piece of v within `far` of it, v first.
  const std::vector<Index>& from(Index v, const std::vector<Vec3>& points, double far) {
    found_.assign(1, v);
    seen_.clear();
    seen_.insert(v);
    for (std::size_t k = 0; k < found_.size(); ++k)
      for (Index f : mesh_.star(found_[k]))
        for (Index w : mesh_.facets[f]) {
          if (!seen_.insert(w)) continue;
          if (distance(points[w], points[v]) <= far && is_alike(v, w)) found_.push_back(w);
        }
    return found_;
  }

 private:
  bool is_alike(Index v, Index w) const {
    return length(pieces_[w].normal - pieces_[v].normal) <= 2 * pieces_[v].width;
  }

  const FacetMesh& mesh_;
  const std::vector<Piece>& pieces_;
  SmallSet seen_;
  std::vector<Index> found_;
};

// How far above `points[v]` its piece is. A sample at p with the normal m says: by the mean of n·d
// and m·d, d = p - points[v]; on a sphere, and on any quadric to third order, that is 0 between two
// points of it.
double height_of_piece(const NoisySamples& samples, const std::vector<Vec3>& points,
                       const std::vector<Piece>& pieces, Walk& walk, Index v) {
  const double h = samples.spacing[v];
  double sum = 0, all = 0, squares = 0;
  for (Index w : walk.from(v, points, say_reach * h)) {
    const Vec3 normal = 0.5 * (pieces[v].normal + pieces[w].normal);
    const double height = dot(normal, samples.measured[w] - points[v]);
    const double off = std::min(std::abs(height) / (gate * samples.level[v]), 1.0);
    const double weight = falloff(points[w] - points[v], say_width * h) *
                          falloff(pieces[w].normal - pieces[v].normal, pieces[v].width) *
                          (1 - off * off) * (1 - off * off);
    sum += weight * height;
    all += weight;
    squares += weight * weight;
  }
  if (!(all > 0)) return 0;
  // Inverse variances: of the mean over the neighbours, and of where the sample was. A place that
  // fewer samples back has a smaller say still: patches stay small where they fit badly.
  const double votes = all * all / squares, given = samples.backing[v];
  const double backing = given * std::min(given / votes, 1.0);
  const double back = dot(pieces[v].normal, samples.points[v] - points[v]);
  return (votes * (sum / all) + backing * back) / (votes + backing);
}

}  // namespace

std::vector<Vec3> settle_samples(const NoisySamples& samples, const FacetMesh& mesh, Job& job) {
  const FilteredNormals filtered = filter_normals(samples.points, mesh, job.threads());
  job.tick(0.5);
  std::vector<Piece> pieces(samples.points.size());
  parallel_for(pieces.size(), job.threads(), [&](std::size_t v) {
    pieces[v] = find_piece(samples.points, mesh, filtered, static_cast<Index>(v));
  });
  std::vector<Vec3> now = samples.points, next = now;
  for (int pass = 0; pass < passes; ++pass) {
    parallel_chunks(now.size(), grain, job.threads(), [&](std::size_t begin, std::size_t end) {
      if (job.cancelled()) return;
      Walk walk(mesh, pieces);
      for (std::size_t v = begin; v < end; ++v) {
        if (!(samples.level[v] > 0) || pieces[v].normal == Vec3{}) continue;
        const double height = height_of_piece(samples, now, pieces, walk, static_cast<Index>(v));
        next[v] = now[v] + height * pieces[v].normal;
      }
    });
    now = next;
    job.tick(1);
  }
  return now;
}

}  // namespace arris
