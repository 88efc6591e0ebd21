// The places of a cloud at which its noise is measured, and what is measured there.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "arris/types.h"
#include "base/job.h"
#include "cloud/nearest.h"

namespace arris {

// Sizes of the neighbourhoods. The smallest leaves a quadric six degrees of freedom; the larger
// ones serve where the noise exceeds the spacing and a small neighbourhood is not flat.
inline constexpr std::array<std::size_t, 6> patch_sizes = {12, 24, 48, 96, 192, 384};

// A neighbourhood shows the surface, not only the noise, if it is this many times wider than deep.
inline constexpr double wide_enough = 4;

// Deviations from quadrics of growing size at one place.
struct DeviationCurve {
  std::array<double, patch_sizes.size()> deviation{};
  std::array<double, patch_sizes.size()> radius{};
  double plane = 0;       // deviation of the nearest few from a plane
  bool flat = false;      // pooled: some of the places nearby are exactly flat
  std::size_t known = 0;  // sizes measured
};

// Each place is measured once, when it is first asked for.
class Sites {
 public:
  // `tree` is that of `points`; both must outlive the sites, which stand `at` some of the points.
  Sites(const std::vector<Vec3>& points, const NearestSample& tree, std::vector<Vec3> at);

  std::size_t size() const noexcept { return at_.size(); }
  Vec3 at(std::size_t i) const noexcept { return at_[i]; }

  // Those whose curves are pooled at site i, itself the first.
  void find_near(std::size_t i, std::vector<NearestSample::Hit>& hits) const;
  // The `count` nearest to p.
  void find_near(Vec3 p, std::size_t count, std::vector<NearestSample::Hit>& hits) const;

  // Parallel; `which` are distinct.
  void measure(const std::vector<Index>& which, Job& job);

  // The curve of a neighbourhood of places, at which an edge may run through most of them. All
  // sites near i must have been measured. `hits` is overwritten.
  DeviationCurve pooled(std::size_t i, std::vector<NearestSample::Hit>& hits) const;

 private:
  const std::vector<Vec3>& points_;
  const NearestSample& tree_;
  std::vector<Vec3> at_;
  NearestSample near_;
  std::vector<DeviationCurve> curves_;
  std::vector<std::uint8_t> measured_;
};

// Places whose curves are pooled.
inline constexpr std::size_t pooled_sites = 32;

}  // namespace arris
