#include "feature/settle.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "base/vec.h"
#include "feature/pieces.h"

namespace arris {
namespace {

// Who has a say in where a sample goes: weights fall off with the distance, in units of spacing, as
// a Gaussian of this width, cut off at twice that. Wider ones lie less in noise, but bend down
// towards edges, where normals of the first surface do.
constexpr double say_width = 2.5, say_reach = 5;
// And with the unlikeness of normals (pieces.h), and with the distance from the surface: none at so
// many deviations of the noise.
constexpr double gate = 4;
// Samples move all at once; after three times they hardly do.
constexpr int passes = 3;
constexpr std::size_t grain = 1024;  // samples a chunk

// How far above `points[v]` its piece is. A sample at p with the normal m says: by the mean of n·d
// and m·d, d = p - points[v]; on a sphere, and on any quadric to third order, that is 0 between two
// points of it.
double height_of_piece(const NoisySamples& samples, const std::vector<Vec3>& points,
                       const std::vector<Piece>& pieces, PieceWalk& walk, Index v) {
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
  const std::vector<Piece> pieces = find_pieces(samples.points, mesh, job.threads());
  job.tick(0.5);
  std::vector<Vec3> now = samples.points, next = now;
  for (int pass = 0; pass < passes; ++pass) {
    parallel_chunks(now.size(), grain, job.threads(), [&](std::size_t begin, std::size_t end) {
      if (job.cancelled()) return;
      PieceWalk walk(mesh, pieces);
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
