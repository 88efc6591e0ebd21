#include "cloud/thickets.h"

#include <algorithm>
#include <iterator>

#include "base/parallel.h"
#include "cloud/filling.h"

namespace arris {
namespace {

class Thickets {
 public:
  Thickets(const Neighbours& near, double limit, Job& job)
      : near_(near), crowded_(near.size(), 0), enclosed_(near.size(), 0) {
    parallel_for(near.size(), job.threads(), [&](std::size_t i) {
      const auto p = static_cast<Index>(i);
      if (near.gone(p)) return;
      crowded_[i] = evenness(near, p) < limit;
      enclosed_[i] = is_enclosed(near, p);
    });
  }

  // From the midst of each to its border.
  std::vector<std::uint8_t> spread() const {
    std::vector<std::uint8_t> found(near_.size(), 0);
    std::vector<Index> reached;
    for (Index p = 0; p < near_.size(); ++p)
      if (is_in_midst(p)) {
        found[p] = 1;
        reached.push_back(p);
      }
    for (std::size_t k = 0; k < reached.size(); ++k)
      for (Index q : near_.of(reached[k]))
        if (!found[q] && (is_at_border(q) || is_surrounded(q, found))) {
          found[q] = 1;
          reached.push_back(q);
        }
    return found;
  }

 private:
  auto crowded() const {
    return [this](Index q) { return crowded_[q] != 0; };
  }
  auto enclosed() const {
    return [this](Index q) { return enclosed_[q] != 0; };
  }
  bool is_in_midst(Index p) const {
    return !near_.gone(p) && arris::is_in_midst(near_, p, crowded(), enclosed());
  }
  bool is_at_border(Index p) const {
    return count_round(p, near_.of(p), crowded()) >= border.crowded &&
           count_round(p, near_.of(p), enclosed()) >= border.enclosed;
  }
  // Most of its company belongs to the clump: one of its outermost points, which are sparse.
  bool is_surrounded(Index p, const std::vector<std::uint8_t>& found) const {
    const auto& company = near_.of(p);
    return 2 * std::count_if(company.begin(), company.end(),
                             [&](Index q) { return found[q] != 0; }) >
           std::ssize(company);
  }

  const Neighbours& near_;
  std::vector<std::uint8_t> crowded_, enclosed_;
};

}  // namespace

std::vector<std::uint8_t> find_thickets(const Neighbours& near, Job& job) {
  const double limit = crowded_below(near);
  if (limit == 0) return std::vector<std::uint8_t>(near.size(), 0);
  return Thickets(near, limit, job).spread();
}

}  // namespace arris
