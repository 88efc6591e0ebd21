#include "noise/project.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.h"
#include "base/parallel.h"
#include "base/vec.h"

namespace arris {
namespace {

// A sample fits a patch if it lies within this many deviations of it.
constexpr double gate = 3;

// Two planes that fit within the gate meet within this many deviations unless they are nearly
// parallel.
constexpr double farthest_move = 5;

// Patches whose normals differ by less are one piece of surface.
const double same_piece = std::cos(radians(20));

// A further piece counts if its best patch has this share of the weight of the best of all.
constexpr double least_weight = 0.1;

// A bevel: its normal lies within so much (a sine) of the plane of the two others, and its best
// patch has less than this share of their weight.
constexpr double bevel_tilt = 0.34, bevel_weight = 0.6;
constexpr std::size_t most_pieces = 5;

constexpr std::size_t most_candidates = 64;

// The surface at the sample as one patch sees it.
struct Candidate {
  double distance;  // of the sample above the patch, along the normal
  Vec3 normal;
  double weight;
  Vec3 middle;  // of the patch
};

// A plane at the sample on which candidates of like orientation agree.
struct Piece {
  double distance;
  Vec3 normal;
  double weight;  // of its best candidate
  Vec3 middle;
};

void find_candidates(const std::vector<Vec3>& points, Index at, double level,
                     const std::vector<PatchFit>& fits, const std::vector<NearestSample::Hit>& hits,
                     const MayBear& may_bear, std::vector<Candidate>& found) {
  found.clear();
  for (const auto& hit : hits) {
    const PatchFit& patch = fits[hit.index];
    if (patch.fit.terms == 0) continue;
    const Vec3 local = patch.fit.frame.to_frame(points[at]);
    if (!patch.covers(local)) continue;
    const HeightFit::Offset offset = patch.fit.offset(points[at]);
    const double variance = patch.fit.variance(local.x, local.y);
    if (std::abs(offset.distance) > gate * level * std::sqrt(1 + variance)) continue;
    if (may_bear && !may_bear(at, patch, offset.normal)) continue;
    found.push_back({offset.distance, offset.normal, 1 / variance, patch.fit.frame.origin});
  }
}

// Takes the best candidate and all that are oriented like it out of the list.
Piece take_piece(std::vector<Candidate>& candidates) {
  const Candidate best =
      *std::max_element(candidates.begin(), candidates.end(),
                        [](const Candidate& a, const Candidate& b) { return a.weight < b.weight; });
  Piece piece{};
  double weight = 0;
  const auto joins = [&](const Candidate& c) {
    return std::abs(dot(c.normal, best.normal)) >= same_piece;
  };
  for (const Candidate& c : candidates) {
    if (!joins(c)) continue;
    const double sign = dot(c.normal, best.normal) < 0 ? -1 : 1;
    weight += c.weight;
    piece.distance += sign * c.weight * c.distance;
    piece.normal = piece.normal + sign * c.weight * c.normal;
    piece.middle = piece.middle + c.weight * c.middle;
  }
  piece.weight = best.weight;
  piece.distance /= weight;
  piece.normal = normalized(piece.normal);
  piece.middle = 1 / weight * piece.middle;
  std::erase_if(candidates, joins);
  return piece;
}

// A small patch astride an edge bevels it: is the third of these pieces such a one, parallel to the
// edge of the other two and much less certain?
bool is_bevel(const Piece& a, const Piece& b, const Piece& third) {
  const Vec3 edge = cross(a.normal, b.normal);
  return std::abs(dot(third.normal, edge)) < bevel_tilt * length(edge) &&
         third.weight < bevel_weight * std::min(a.weight, b.weight);
}

std::vector<Piece> find_pieces(std::vector<Candidate>& candidates) {
  std::vector<Piece> pieces;
  double best = 0;
  for (const Candidate& c : candidates) best = std::max(best, c.weight);
  std::erase_if(candidates, [&](const Candidate& c) { return c.weight < least_weight * best; });
  while (!candidates.empty() && pieces.size() < most_pieces)
    pieces.push_back(take_piece(candidates));
  // Heaviest first, so what bevels is judged after what it bevels.
  std::vector<Piece> kept;
  for (const Piece& piece : pieces) {
    bool bevel = false;
    for (std::size_t i = 0; i < kept.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) bevel = bevel || is_bevel(kept[i], kept[j], piece);
    if (!bevel && kept.size() < 3) kept.push_back(piece);
  }
  return kept;
}

// Where the planes of the first `count` pieces meet, nearest to p: offsets from p.
Vec3 meet(const std::vector<Piece>& pieces, std::size_t count, Vec3 p) {
  // Kaczmarz' alternating projections converge geometrically for planes that clearly differ.
  constexpr int rounds = 60;
  Vec3 x = p;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < count; ++i) {
      const Piece& piece = pieces[i];
      const double above = dot(x - p, piece.normal) + piece.distance;
      x = x - above * piece.normal;
    }
  return x;
}

// Does the piece extend to its foot point, on the same side of the others as its own patches?
bool reaches(const std::vector<Piece>& pieces, std::size_t which, Vec3 p, Vec3 foot) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i == which) continue;
    const Piece& other = pieces[i];
    const double here = dot(foot - p, other.normal) + other.distance;
    const double there = dot(pieces[which].middle - p, other.normal) + other.distance;
    if (here * there < 0) return false;
  }
  return true;
}

// Where the sample belongs, and the weight of the pieces that say so.
struct Landing {
  Vec3 point;
  double weight;
};

Landing land(std::vector<Piece> pieces, Vec3 p, double level) {
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    return std::abs(a.distance) < std::abs(b.distance);
  });
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Vec3 foot = p - pieces[i].distance * pieces[i].normal;
    if (reaches(pieces, i, p, foot)) return {foot, pieces[i].weight};
  }
  const Vec3 edge = meet(pieces, 2, p);
  if (distance(edge, p) <= farthest_move * level)
    return {edge, std::min(pieces[0].weight, pieces[1].weight)};
  return {p - pieces[0].distance * pieces[0].normal, pieces[0].weight};
}

}  // namespace

Projection project_samples(const std::vector<Vec3>& points, const std::vector<double>& level,
                           const std::vector<PatchFit>& fits, Job& job, const MayBear& may_bear) {
  Projection result{points, std::vector<double>(points.size(), 0)};
  std::vector<Vec3> middles;
  for (std::size_t i = 0; i < points.size(); i += patch_stride) middles.push_back(points[i]);
  const NearestSample tree(middles);
  parallel_chunks(points.size(), 256, job.threads(), [&](std::size_t begin, std::size_t end) {
    if (job.cancelled()) return;
    std::vector<NearestSample::Hit> hits;
    std::vector<Candidate> candidates;
    for (std::size_t i = begin; i < end; ++i) {
      if (!(level[i] > 0)) continue;
      tree.nearest(points[i], most_candidates, hits);
      find_candidates(points, static_cast<Index>(i), level[i], fits, hits, may_bear, candidates);
      if (candidates.empty()) continue;
      const Landing landing = land(find_pieces(candidates), points[i], level[i]);
      result.points[i] = landing.point;
      result.backing[i] = landing.weight;
    }
  });
  job.tick(1);
  return result;
}

}  // namespace arris
