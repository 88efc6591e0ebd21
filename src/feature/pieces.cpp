#include "feature/pieces.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "feature/normal_filter.h"

namespace arris {
namespace {

// The width of unlikeness in units of the likeness of the filter. Wider than in the filter: on a
// cylinder the normals of a piece differ.
constexpr double unlikeness = 1.5;

Piece find_piece(const std::vector<Vec3>& points, const FacetMesh& mesh,
                 const FilteredNormals& filtered, Index v) {
  Piece piece;
  for (Index f : mesh.star(v)) {
    const double width = unlikeness * filtered.likeness[f];
    piece.width = piece.width > 0 ? std::min(piece.width, width) : width;
  }
  double most = 0;
  std::vector<Index> buffer;
  for (Index f : mesh.star(v)) {
    Vec3 sum{};
    double all = 0;
    for (Index g : mesh.star_near(v, f, buffer)) {
      const double weight = angle_at(points, mesh.facets[g], v) *
                            falloff(filtered.normal[f] - filtered.normal[g], piece.width);
      sum = sum + weight * filtered.normal[g];
      all += weight;
    }
    if (all <= most || sum == Vec3{}) continue;
    most = all;
    piece.normal = normalized(sum);
  }
  return piece;
}

}  // namespace

double falloff(Vec3 difference, double width) {
  return std::exp(-squared_length(difference) / (2 * width * width));
}

std::vector<Piece> find_pieces(const std::vector<Vec3>& points, const FacetMesh& mesh,
                               unsigned threads) {
  const FilteredNormals filtered = filter_normals(points, mesh, threads);
  std::vector<Piece> pieces(points.size());
  parallel_for(pieces.size(), threads, [&](std::size_t v) {
    pieces[v] = find_piece(points, mesh, filtered, static_cast<Index>(v));
  });
  return pieces;
}

const std::vector<Index>& PieceWalk::from(Index v, const std::vector<Vec3>& points, double far) {
  found_.assign(1, v);
  from_.clear();
  seen_.clear();
  seen_.insert(v);
  if (mesh_.star(v).empty()) return found_;
  from_.push_back(mesh_.star(v)[0]);
  for (std::size_t k = 0; k < found_.size(); ++k)
    for (Index f : mesh_.star_near(found_[k], from_[k], buffer_))
      for (Index w : mesh_.facets[f]) {
        if (!seen_.insert(w)) continue;
        if (distance(points[w], points[v]) > far || !is_alike(v, w)) continue;
        found_.push_back(w);
        from_.push_back(f);
      }
  return found_;
}

bool PieceWalk::is_alike(Index v, Index w) const {
  return length(pieces_[w].normal - pieces_[v].normal) <= 2 * pieces_[v].width;
}

}  // namespace arris
