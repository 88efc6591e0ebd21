#include "cloud/nearest.h"

#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>

namespace arris {
namespace {

// The cloud as nanoflann reads it.
struct Adaptor {
  const std::vector<Vec3>& points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    const Vec3& p = points[i];
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Index3 = nanoflann::KDTreeSingleIndexAdaptor<
    nanoflann::L2_Simple_Adaptor<double, Adaptor, double, Index>, Adaptor, 3, Index>;

}  // namespace

struct NearestSample::Tree {
  Adaptor adaptor;
  Index3 index;
  explicit Tree(const std::vector<Vec3>& points) : adaptor{points}, index(3, adaptor, {10}) {}
};

NearestSample::NearestSample(const std::vector<Vec3>& points)
    : tree_(std::make_unique<Tree>(points)) {
  tree_->index.buildIndex();
}
NearestSample::~NearestSample() = default;

NearestSample::Hit NearestSample::operator()(Vec3 query) const {
  const double at[3] = {query.x, query.y, query.z};
  Index index = no_index;
  double squared = 0;
  nanoflann::KNNResultSet<double, Index> result(1);
  result.init(&index, &squared);
  tree_->index.findNeighbors(result, at, nanoflann::SearchParams());
  return {index, std::sqrt(squared)};
}

void NearestSample::nearest(Vec3 query, std::size_t k, std::vector<Hit>& hits) const {
  const double at[3] = {query.x, query.y, query.z};
  k = std::min(k, tree_->adaptor.points.size());
  std::vector<Index> index(k);
  std::vector<double> squared(k);
  nanoflann::KNNResultSet<double, Index> result(k);
  result.init(index.data(), squared.data());
  tree_->index.findNeighbors(result, at, nanoflann::SearchParams());
  hits.resize(k);
  for (std::size_t i = 0; i < k; ++i) hits[i] = {index[i], std::sqrt(squared[i])};
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
  });
}

}  // namespace arris
