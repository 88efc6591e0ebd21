#include "cloud/neighbours.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"
#include "base/vec.h"
#include "cloud/nearest.h"

namespace arris {

Neighbours::Neighbours(const std::vector<Vec3>& points, Job& job)
    : points_(points),
      left_(points.size()),
      gone_(points.size(), 0),
      of_(points.size()),
      reach_(points.size(), 0) {
  std::vector<Index> all(points.size());
  std::iota(all.begin(), all.end(), Index{0});
  find(all, job);
}

Flatness flatness_round(const std::vector<Vec3>& points, Index p, std::span<const Index> neighbours,
                        Index without) {
  std::array<Vec3, Neighbours::patch + 1> around;
  std::size_t n = 0;
  around[n++] = points[p];
  for (std::size_t j = 0; j < neighbours.size() && n <= Neighbours::patch; ++j)
    if (neighbours[j] != without) around[n++] = points[neighbours[j]];
  return flatness({around.data(), n});
}

void Neighbours::remove(const std::vector<std::uint8_t>& marked, Job& job) {
  for (std::size_t p = 0; p < size(); ++p)
    if (marked[p] && !gone_[p]) {
      gone_[p] = 1;
      --left_;
    }
  std::vector<Index> bereft;
  for (std::size_t p = 0; p < size(); ++p)
    if (!gone_[p] &&
        std::any_of(of_[p].begin(), of_[p].end(), [&](Index q) { return gone_[q] != 0; }))
      bereft.push_back(static_cast<Index>(p));
  find(bereft, job);
}

void Neighbours::find(const std::vector<Index>& whom, Job& job) {
  if (whom.empty()) return;
  std::vector<Vec3> left;
  std::vector<Index> name;
  left.reserve(left_);
  name.reserve(left_);
  for (std::size_t p = 0; p < size(); ++p)
    if (!gone_[p]) {
      left.push_back(points_[p]);
      name.push_back(static_cast<Index>(p));
    }
  const NearestSample tree(left);
  constexpr std::size_t grain = 4096;
  parallel_chunks(whom.size(), grain, job, [&](std::size_t begin, std::size_t end) {
    std::vector<NearestSample::Hit> hits;
    for (std::size_t k = begin; k < end; ++k) {
      const Index p = whom[k];
      tree.nearest(points_[p], count + 1, hits);  // the first is p itself
      for (std::size_t j = 0; j < count; ++j) of_[p][j] = name[hits[j + 1].index];
      reach_[p] = hits[rank].distance;
    }
  });
}

}  // namespace arris
