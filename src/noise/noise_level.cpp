#include "noise/noise_level.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/distinct.h"
#include "base/parallel.h"
#include "noise/sites.h"

namespace arris {
namespace {

// Noise leaves the deviation as it is when the neighbourhood doubles; an edge raises it by 1.41,
// curvature by 2.8 and more.
constexpr double noise_growth = 1.2;
constexpr double curvature_growth = 8;  // of the variance: the square of 2.8

// Noise leaves the deviation as it is also in the smallest neighbourhood of all, from a plane;
// there facets and steps of the surface itself show less (they are flat) and curvature shows more.
constexpr double least_plane_share = 0.6, most_plane_share = 1.35;

// Every so manyth sample is a place to measure at, in clouds with enough of them.
constexpr std::size_t fewest_sites = 1000, longest_stride = 4;

// Noise below this share of the spacing turns facets by less than half a degree: left alone.
constexpr double least_noise = 0.004;

// A cloud has noise if so many of its places say so. Of 190 clean clouds the highest shares are
// 0.13, 0.42 and 0.45 (facets as wide as the spacing; a scanned rocker arm).
constexpr double least_by_all = 0.25, least_by_quadrics = 0.6, least_by_plane = 0.6;

// Where edges and narrow faces leave few such places, noise still shows by being the same all over:
// the 10 % quantile of the deviations of six samples from a plane is this share of their median.
// With noise it was 0.75 and more on 38 scans; on clean clouds on which at least a quarter of the
// places look like noise to the smallest sizes, details of shape, it was 0.55 at most.
constexpr double even_quantile = 0.1, even_share = 0.65, least_if_even = 0.25;

// A place without a clear level of its own takes that of the 32 nearest if so many of them have
// one.
constexpr double least_near = 0.3;

// The level of a sample is the median of those of the nearest places.
constexpr std::size_t smoothing_sites = 8;

// Pooled as they are, levels still scatter by a tenth, and edges and narrow faces only ever raise
// them: by a sixth in the median of random solids. So the lower quartile of the levels of this many
// places, which is right to 4 % there, counts for all samples nearby whose own level does not deny
// it. Every so manyth place has such a region: they overlap nearly whole.
constexpr std::size_t region_sites = 256, region_stride = 16;
constexpr double region_quantile = 0.25;
// The upper quartile is 1.1 to 1.3 times as large in those solids; if more, two levels meet here.
constexpr double most_spread = 1.5;
// A sample's own level denies it if it is lower by more than chance, or higher than edges raise it.
constexpr double least_of_region = 0.8, most_of_region = 3;

// Large clouds are found clean by a sample of their places: so many at first, and with less than
// exp(-14), a millionth, of a chance of error.
constexpr std::size_t first_sample = 64;
constexpr double certainty = 14;

constexpr double unknown = -1;

// What the pooled curve of a place says.
struct Verdict {
  double level = unknown;
  // Which pairs of sizes agree on it: two quadrics, of which the smaller agrees with the plane too,
  // or exceeds it no less; and the smallest quadric with the plane.
  bool by_all = false, by_quadrics = false, by_plane = false;
};

Verdict judge(const DeviationCurve& c) {
  Verdict v;
  if (c.known == 0) return v;
  if (c.flat && c.deviation[0] >= least_noise * c.radius[0]) return v;
  const double share = c.plane / c.deviation[0];
  v.by_plane = c.deviation[0] >= least_noise * c.radius[0] && share > least_plane_share &&
               share < most_plane_share;
  if (v.by_plane) v.level = std::min(c.deviation[0], c.plane);
  for (std::size_t j = 0; j + 1 < c.known; ++j) {
    const double here = c.deviation[j], above = c.deviation[j + 1];
    if (here * wide_enough > c.radius[j]) continue;
    if (here < least_noise * c.radius[j]) {
      v.level = 0;
      return v;
    }
    v.by_quadrics = above < noise_growth * here && share > least_plane_share;
    v.by_all = v.by_quadrics && v.by_plane;
    if (v.by_quadrics) {
      const double curved = std::max(0.0, above * above - here * here) / (curvature_growth - 1);
      v.level = std::sqrt(here * here - curved);
    }
    return v;
  }
  return v;
}

double quantile(std::vector<double>& values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double median(std::vector<double>& values) {
  return quantile(values, 0.5);
}

// The deviations from planes hardly differ between places.
bool is_even(const std::vector<DeviationCurve>& pooled) {
  std::vector<double> planes;
  for (const DeviationCurve& c : pooled)
    if (c.known > 0) planes.push_back(c.plane);
  if (planes.empty()) return false;
  const double middle = median(planes);
  return quantile(planes, even_quantile) >= even_share * middle;
}

// How many places say that there is noise, and of how many.
struct Evidence {
  double all = 0, quadrics = 0, plane = 0, places = 0;

  void add(const Verdict& v) {
    all += v.by_all ? 1 : 0;
    quadrics += v.by_quadrics ? 1 : 0;
    plane += v.by_plane ? 1 : 0;
    places += 1;
  }
};

// Is there noise in this cloud at all? Clean ones have places that look noisy.
bool is_noisy(const std::vector<Verdict>& verdicts, const std::vector<DeviationCurve>& pooled) {
  Evidence e;
  for (const Verdict& v : verdicts) e.add(v);
  return e.all >= least_by_all * e.places || e.quadrics >= least_by_quadrics * e.places ||
         e.plane >= least_by_plane * e.places ||
         (e.plane >= least_if_even * e.places && is_even(pooled));
}

// Whether so few of a sample of places would say so, were it `limit` of all, that the chance is
// below exp(-certainty): Chernoff's bound.
bool is_surely_below(double count, double places, double limit) {
  const double share = count / places;
  if (share >= limit) return false;
  const double agreeing = share > 0 ? share * std::log(share / limit) : 0;
  return places * (agreeing + (1 - share) * std::log((1 - share) / (1 - limit))) >= certainty;
}

bool is_surely_clean(const Evidence& e) {
  return is_surely_below(e.all, e.places, least_by_all) &&
         is_surely_below(e.quadrics, e.places, least_by_quadrics) &&
         is_surely_below(e.plane, e.places, std::min(least_by_plane, least_if_even));
}

// The sites number k of van der Corput's sequence, begin <= k < end: evenly spread along the curve
// that samples are in the order of, whatever `end` is.
std::vector<Index> spread_out(std::size_t begin, std::size_t end, std::size_t sites) {
  std::vector<Index> places;
  for (std::size_t k = begin; k < end; ++k) {
    double position = 0, step = 0.5;
    for (std::size_t bits = k; bits > 0; bits >>= 1, step /= 2)
      if (bits & 1) position += step;
    places.push_back(static_cast<Index>(position * static_cast<double>(sites)));
  }
  return places;
}

// Looks at a sample of the sites, doubled until it is clear that the cloud has no noise, or not
// clear that it has none. False says nothing.
bool is_clean_by_sample(Sites& sites, Job& job) {
  Evidence evidence;
  std::vector<NearestSample::Hit> hits;
  for (std::size_t n = first_sample; n * pooled_sites <= sites.size(); n *= 2) {
    const std::vector<Index> places =
        spread_out(static_cast<std::size_t>(evidence.places), n, sites.size());
    std::vector<Index> needed;
    for (Index i : places) {
      sites.find_near(i, hits);
      for (const auto& h : hits) needed.push_back(h.index);
    }
    keep_distinct(needed);
    sites.measure(needed, job);
    for (Index i : places) evidence.add(judge(sites.pooled(i, hits)));
    if (is_surely_clean(evidence)) return true;
    if (evidence.plane >= least_if_even * evidence.places ||
        evidence.all >= least_by_all * evidence.places)
      return false;
  }
  return false;
}

// The level at a site whose own curve is not that of noise alone: that of the places nearby.
double borrowed_level(const std::vector<double>& levels, const DeviationCurve& own,
                      const std::vector<NearestSample::Hit>& hits, double usual) {
  std::vector<double> near;
  for (const auto& h : hits)
    if (levels[h.index] != unknown) near.push_back(levels[h.index]);
  const double level =
      static_cast<double>(near.size()) < least_near * static_cast<double>(hits.size())
          ? usual
          : median(near);
  return own.known > 0 ? std::min(level, own.deviation[0]) : level;
}

// What the levels of most places in a region agree on.
class Regions {
 public:
  Regions(const Sites& sites, const std::vector<double>& levels, Job& job)
      : centres_(centres(sites)),
        near_(centres_),
        level_((sites.size() + region_stride - 1) / region_stride, 0) {
    parallel_for(level_.size(), job.threads(), [&](std::size_t r) {
      if (!job.cancelled()) level_[r] = common_level(sites, sites.at(r * region_stride), levels);
    });
  }

  // The level at p as that of its region, if they agree.
  double agreed_level(Vec3 p, double own, std::vector<NearestSample::Hit>& hits) const {
    near_.nearest(p, 1, hits);
    const double region = level_[hits[0].index];
    return own > least_of_region * region && own < most_of_region * region ? region : own;
  }

 private:
  static std::vector<Vec3> centres(const Sites& sites) {
    std::vector<Vec3> result;
    for (std::size_t i = 0; i < sites.size(); i += region_stride) result.push_back(sites.at(i));
    return result;
  }

  // 0 where half the places have no noise, or where there is no common level.
  static double common_level(const Sites& sites, Vec3 centre, const std::vector<double>& levels) {
    std::vector<NearestSample::Hit> hits;
    sites.find_near(centre, region_sites, hits);
    std::vector<double> near;
    for (const auto& h : hits)
      if (levels[h.index] > 0) near.push_back(levels[h.index]);
    if (2 * near.size() < hits.size()) return 0;
    const double low = quantile(near, region_quantile);
    return quantile(near, 1 - region_quantile) < most_spread * low ? low : 0;
  }

  std::vector<Vec3> centres_;
  NearestSample near_;
  std::vector<double> level_;
};

// What follows judges noise by 24 samples round each of 32 places; fewer samples than this are read
// as they are, since a block of points that fills space would look like one thick layer.
constexpr std::size_t fewest_points = 500;

}  // namespace

std::vector<double> estimate_noise(const std::vector<Vec3>& points, const NearestSample& tree,
                                   Job& job) {
  std::vector<double> result(points.size(), 0);
  if (points.size() < fewest_points) return result;
  const std::size_t stride =
      std::clamp<std::size_t>(points.size() / fewest_sites, 1, longest_stride);
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < points.size(); i += stride) places.push_back(points[i]);
  Sites sites(points, tree, std::move(places));
  if (is_clean_by_sample(sites, job)) return result;
  std::vector<Index> all(sites.size());
  std::iota(all.begin(), all.end(), Index{0});
  sites.measure(all, job);
  std::vector<DeviationCurve> pooled(sites.size());
  std::vector<Verdict> verdicts(sites.size());
  parallel_chunks(sites.size(), 256, job.threads(), [&](std::size_t begin, std::size_t end) {
    if (job.cancelled()) return;
    std::vector<NearestSample::Hit> hits;
    for (std::size_t i = begin; i < end; ++i) {
      pooled[i] = sites.pooled(i, hits);
      verdicts[i] = judge(pooled[i]);
    }
  });
  job.tick(0.2);
  if (!is_noisy(verdicts, pooled)) return result;

  std::vector<double> levels, accepted;
  for (const Verdict& v : verdicts) {
    levels.push_back(v.level);
    if (v.level != unknown) accepted.push_back(v.level);
  }
  const double usual =
      accepted.empty() ? std::numeric_limits<double>::infinity() : median(accepted);
  std::vector<double> filled = levels;
  parallel_chunks(sites.size(), 256, job.threads(), [&](std::size_t begin, std::size_t end) {
    std::vector<NearestSample::Hit> hits;
    for (std::size_t i = begin; i < end; ++i) {
      if (levels[i] != unknown) continue;
      sites.find_near(i, hits);
      filled[i] = borrowed_level(levels, pooled[i], hits, usual);
    }
  });
  const Regions regions(sites, filled, job);
  parallel_chunks(points.size(), 256, job.threads(), [&](std::size_t begin, std::size_t end) {
    std::vector<NearestSample::Hit> hits;
    std::vector<double> near;
    for (std::size_t i = begin; i < end; ++i) {
      sites.find_near(points[i], smoothing_sites, hits);
      near.clear();
      for (const auto& h : hits) near.push_back(filled[h.index]);
      result[i] = regions.agreed_level(points[i], median(near), hits);
    }
  });
  return result;
}

}  // namespace arris
