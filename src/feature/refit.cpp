#include "feature/refit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "base/vec.h"
#include "feature/pieces.h"
#include "noise/adaptive_fit.h"
#include "noise/height_fit.h"
#include "noise/project.h"

namespace arris {
namespace {

// How far patches reach, in units of spacing: three to four hundred samples where it is flat, which
// bear a place to a tenth of the noise even at their border.
constexpr double reach = 10;
// A sample was not measured of a patch that it was measured so many deviations away from.
constexpr double gate = 4;
constexpr std::size_t grain = 128;  // patches a chunk

bool has_piece(const NoisySamples& samples, const std::vector<Piece>& pieces, Index v) {
  return samples.level[v] > 0 && !(pieces[v].normal == Vec3{});
}

// At every patch_stride-th point.
std::vector<PatchFit> fit_pieces(const NoisySamples& samples, const FacetMesh& mesh,
                                 const std::vector<Piece>& pieces, Job& job) {
  const std::vector<Vec3>& points = samples.points;
  std::vector<PatchFit> fits((points.size() + patch_stride - 1) / patch_stride);
  parallel_chunks(fits.size(), grain, job.threads(), [&](std::size_t begin, std::size_t end) {
    if (job.cancelled()) return;
    PieceWalk walk(mesh, pieces);
    std::vector<std::pair<double, Index>> near;
    std::vector<Vec3> local;
    for (std::size_t k = begin; k < end; ++k) {
      const auto v = static_cast<Index>(k * patch_stride);
      if (!has_piece(samples, pieces, v)) continue;
      const Frame frame = frame_at(points[v], pieces[v].normal);
      near.clear();
      for (Index w : walk.from(v, points, reach * samples.spacing[v]))
        if (samples.level[w] > 0) near.emplace_back(distance(points[w], points[v]), w);
      // By where they are now: by where they were measured those off the surface would come last.
      std::sort(near.begin(), near.end());
      local.clear();
      for (const auto& [far, w] : near) local.push_back(frame.to_frame(samples.measured[w]));
      fits[k] = fit_patch(local, frame, samples.level[v]);
    }
  });
  return fits;
}

}  // namespace

std::vector<Vec3> refit_samples(const NoisySamples& samples, const FacetMesh& mesh, Job& job) {
  const std::vector<Piece> pieces = find_pieces(samples.points, mesh, job.threads());
  job.tick(0.3);
  const std::vector<PatchFit> fits = fit_pieces(samples, mesh, pieces, job);
  job.tick(0.7);
  // The sample was measured near the patch, and a point beside it on the mesh is on such a piece:
  // the other side of a thin wall, or of a gap, has no say.
  const auto may_bear = [&](Index v, const PatchFit& patch, Vec3 normal) {
    if (std::abs(patch.fit.offset(samples.measured[v]).distance) > gate * samples.level[v])
      return false;
    for (Index f : mesh.star(v))
      for (Index w : mesh.facets[f])
        if (has_piece(samples, pieces, w) && length(pieces[w].normal - normal) <= pieces[w].width)
          return true;
    return false;
  };
  return project_samples(samples.points, samples.level, fits, job, may_bear).points;
}

}  // namespace arris
