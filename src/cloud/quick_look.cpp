#include "cloud/quick_look.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <numeric>

#include "base/parallel.h"
#include "base/vec.h"
#include "cloud/clumps.h"
#include "cloud/filling.h"
#include "cloud/nearest.h"
#include "cloud/neighbours.h"
#include "cloud/stray.h"

namespace arris {
namespace {

constexpr std::size_t grain = 4096;

// Half of the company of every point, and its reach; the rest is looked for when it is asked for.
class Company {
 public:
  static constexpr std::size_t half = company_rank;
  static_assert(half >= Neighbours::rank && half >= Neighbours::patch);

  Company(const std::vector<Vec3>& points, Job& job)
      : points_(points),
        tree_(points),
        nearest_(points.size()),
        nearest_distance_(points.size()),
        reach_(points.size()) {
    parallel_chunks(points.size(), grain, job, [&](std::size_t begin, std::size_t end) {
      std::vector<NearestSample::Hit> hits;
      for (std::size_t p = begin; p < end; ++p) {
        tree_.nearest(points_[p], half + 1, hits);  // the first is p itself
        for (std::size_t j = 0; j < half; ++j) nearest_[p][j] = hits[j + 1].index;
        nearest_distance_[p] = distance(points_[p], points_[hits[1].index]);
        reach_[p] = hits[Neighbours::rank].distance;
      }
    });
  }

  std::size_t size() const { return points_.size(); }
  Vec3 point(Index p) const { return points_[p]; }
  double reach(Index p) const { return reach_[p]; }
  const std::array<Index, half>& nearest(Index p) const { return nearest_[p]; }
  double nearest_distance(Index p) const { return nearest_distance_[p]; }
  bool gone(Index) const { return false; }
  std::array<Index, Neighbours::count> of(Index p) const {
    std::array<Index, Neighbours::count> company;
    std::vector<NearestSample::Hit> hits;
    tree_.nearest(points_[p], company.size() + 1, hits);
    for (std::size_t j = 0; j < company.size(); ++j) company[j] = hits[j + 1].index;
    return company;
  }
  Flatness flatness_at(Index p) const { return flatness_round(points_, p, nearest_[p], no_index); }
  Flatness flatness_at(Index p, Index without) const {
    return flatness_round(points_, p, of(p), without);
  }

 private:
  const std::vector<Vec3>& points_;
  NearestSample tree_;
  std::vector<std::array<Index, half>> nearest_;
  std::vector<double> nearest_distance_, reach_;
};

bool is_surely_no_stray(const Company& company, Index p) {
  // If the nearer half has reaches large enough, so is the median.
  const auto& nearest = company.nearest(p);
  const double least = company.reach(p) / sparse_ratio;
  return std::all_of(nearest.begin(), nearest.end(),
                     [&](Index q) { return company.reach(q) >= least; }) ||
         !is_stray(company, p, reach_of_company(company, p));
}

bool has_no_strays(const Company& company, Job& job) {
  std::atomic<bool> none = true;
  parallel_chunks(company.size(), grain, job.threads(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end && none; ++p)
      if (!is_surely_no_stray(company, static_cast<Index>(p))) none = false;
  });
  return none;
}

bool has_no_thickets(const Company& company, Job& job) {
  const double limit = crowded_below(company);
  const auto crowded = [&](Index q) { return evenness(company, q) < limit; };
  const auto enclosed = [&](Index q) { return is_enclosed(company, q); };
  std::atomic<bool> none = true;
  parallel_chunks(company.size(), grain, job.threads(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end && none; ++p)
      if (is_in_midst(company, static_cast<Index>(p), crowded, enclosed)) none = false;
  });
  return none;
}

// Links are those that find_clumps joins groups by.
bool is_one_group(const Company& company) {
  std::vector<Index> up(company.size());
  std::iota(up.begin(), up.end(), Index{0});
  const auto root = [&](Index p) {
    while (up[p] != p) p = up[p] = up[up[p]];
    return p;
  };
  std::size_t groups = company.size();
  for (Index p = 0; p < company.size(); ++p)
    for (std::size_t j = 0; j < Neighbours::rank; ++j) {
      const Index q = company.nearest(p)[j];
      if (!are_linked(distance(company.point(p), company.point(q)), company.reach(p),
                      company.reach(q)))
        continue;
      const Index a = root(p), b = root(q);
      if (a == b) continue;
      up[std::max(a, b)] = std::min(a, b);
      --groups;
    }
  return groups == 1;
}

}  // namespace

bool has_no_outliers(const std::vector<Vec3>& points, Job& job) {
  const Company company(points, job);
  return has_no_strays(company, job) && has_no_thickets(company, job) && is_one_group(company);
}

}  // namespace arris
