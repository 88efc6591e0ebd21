#include "cloud/outliers.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "cloud/clumps.h"
#include "cloud/neighbours.h"
#include "cloud/quick_look.h"
#include "cloud/stray.h"
#include "cloud/thickets.h"

namespace arris {
namespace {

// Smaller clouds are left alone: sixteen neighbours are no neighbourhood there.
constexpr std::size_t smallest_cloud = 100;

// How much the reach of a surface may grow from a stray to its neighbour.
constexpr double growth = 1.05;

// If more than this share are strays there is no surface to tell them from.
constexpr double most_outliers = 0.5;

std::size_t fewest_left(const Neighbours& near) {
  return static_cast<std::size_t>((1 - most_outliers) * static_cast<double>(near.size()));
}

// Takes away the strays that have surface for company, round after round, until there are none.
class Peeling {
 public:
  explicit Peeling(Neighbours& near)
      : near_(near),
        expected_(near.size(), std::numeric_limits<double>::infinity()),
        stray_(near.size(), 0) {}

  void run(Job& job) {
    const std::size_t fewest = fewest_left(near_);
    for (;;) {
      parallel_for(near_.size(), job.threads(), [&](std::size_t i) {
        const auto p = static_cast<Index>(i);
        stray_[i] = !near_.gone(p) && is_stray(near_, p, expected(p));
      });
      const auto n = static_cast<std::size_t>(std::count(stray_.begin(), stray_.end(), 1));
      if (n == 0 || near_.left() - n < fewest) return;
      hand_on(job);
      near_.remove(stray_, job);
    }
  }

 private:
  double expected(Index p) const { return std::min(reach_of_company(near_, p), expected_[p]); }

  // What was expected of a stray is expected of its neighbours, whose company may be all strays.
  void hand_on(Job& job) {
    std::vector<double> next = expected_;
    parallel_for(near_.size(), job.threads(), [&](std::size_t i) {
      const auto p = static_cast<Index>(i);
      if (near_.gone(p)) return;
      for (Index q : near_.of(p))
        if (stray_[q]) next[i] = std::min(next[i], growth * expected(q));
    });
    expected_ = std::move(next);
  }

  Neighbours& near_;
  std::vector<double> expected_;  // reach handed on by strays, or infinity
  std::vector<std::uint8_t> stray_;
};

// What is left of a clump is thin, and strays.
void clear_thickets(Neighbours& near, Job& job) {
  const std::vector<std::uint8_t> thicket = find_thickets(near, job);
  const auto n = static_cast<std::size_t>(std::count(thicket.begin(), thicket.end(), 1));
  if (n == 0 || near.left() - n < fewest_left(near)) return;
  near.remove(thicket, job);
}

}  // namespace

std::vector<std::uint8_t> find_outliers(const std::vector<Vec3>& points, Job& job) {
  if (points.size() < smallest_cloud) return std::vector<std::uint8_t>(points.size(), 0);
  if (has_no_outliers(points, job)) return std::vector<std::uint8_t>(points.size(), 0);
  Neighbours near(points, job);
  clear_thickets(near, job);
  Peeling(near).run(job);
  std::vector<std::uint8_t> outlier = find_clumps(near);
  for (Index p = 0; p < points.size(); ++p) outlier[p] |= near.gone(p);
  return outlier;
}

std::uint64_t drop_samples(Samples& samples, const std::vector<std::uint8_t>& drop) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < samples.points.size(); ++k) {
    if (drop[k]) continue;
    samples.points[kept] = samples.points[k];
    samples.source[kept++] = samples.source[k];
  }
  const std::uint64_t dropped = samples.points.size() - kept;
  samples.points.resize(kept);
  samples.source.resize(kept);
  return dropped;
}

}  // namespace arris
