#include "noise/adaptive_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "base/vec.h"

namespace arris {
namespace {

constexpr std::size_t smallest_patch = 10, largest_patch = 400;
constexpr double patch_growth = 1.5;  // of the number of samples
// The distance to the sixth sample, itself counted, is about one spacing.
constexpr std::size_t spacing_rank = 6;
constexpr double wanted_error = 0.006;  // of the spacing

// A patch must be wider than the noise is deep before its plane means anything.
constexpr double least_radius = 3;  // in levels of noise

// Samples farther from the fit than half the radius belong to another sheet.
constexpr double other_sheet = 0.5, least_other_sheet = 4;  // of the radius; of the level

// How far the statistics of the residuals may exceed their expectation, in standard deviations, and
// how much the estimated level itself may be too low.
constexpr double tolerance = 3, level_slack = 1.1;

// A quadric has four times the variance of a plane in the middle of a patch, so it must explain
// clearly more samples to be preferred.
constexpr double quadric_gain = 1.5;

// Where features are known (fit_patch), a plane ends where a quadric through the same samples would
// explain so much more of them that chance does it once in twenty times: curvature shows there
// first.
constexpr double bend_tolerance = 2;

// Residuals are compared with noise also in their means over parts of the patch: a middle and a
// ring of sectors, where noise averages out and a bent surface shows.
constexpr std::size_t cells = sectors + 1;
constexpr double middle = 0.5;  // of the radius

double limit(double freedom, double deviations = tolerance) {
  return freedom + deviations * std::sqrt(2 * freedom);
}

double noise_variance(double level) {
  return level_slack * level_slack * level * level;
}

double sum_of_squares(const HeightFit& fit, const std::vector<Vec3>& local) {
  double sum = 0;
  for (Vec3 p : local) {
    const double r = p.z - fit.height(p.x, p.y);
    sum += r * r;
  }
  return sum;
}

// Does a quadric explain clearly more of the samples than this plane through them?
bool bends(const HeightFit& plane, const std::vector<Vec3>& local, double level) {
  const HeightFit quadric = fit_heights(plane.frame, local, plane.radius, quadric_terms);
  if (quadric.terms == 0) return false;
  const double gain = sum_of_squares(plane, local) - sum_of_squares(quadric, local);
  return gain > noise_variance(level) * limit(quadric_terms - plane_terms, bend_tolerance);
}

// Are the residuals what noise of this level leaves?
bool explained(const HeightFit& fit, const std::vector<Vec3>& local, double level) {
  std::array<double, cells> sum{}, count{};
  double squares = 0;
  for (Vec3 p : local) {
    const double r = p.z - fit.height(p.x, p.y);
    squares += r * r;
    const bool inner = p.x * p.x + p.y * p.y < middle * middle * fit.radius * fit.radius;
    const std::size_t cell = inner ? sectors : sector_of(p);
    sum[cell] += r;
    count[cell] += 1;
  }
  const double variance = noise_variance(level), n = static_cast<double>(local.size());
  if (squares > variance * limit(n - fit.terms)) return false;
  double means = 0, used = 0;
  for (std::size_t j = 0; j < cells; ++j)
    if (count[j] > 0) {
      means += sum[j] * sum[j] / count[j];
      used += 1;
    }
  return used <= fit.terms || means <= variance * limit(used - fit.terms);
}

// A sector ends where its next ring does not fit as a whole: short of the edge by part of a ring.
constexpr double stretch = 1.5;

// A patch of one model, plane or quadric, in growth.
class Growth {
 public:
  // `straight`: a plane may not bend.
  Growth(const std::vector<Vec3>& around, const Frame& frame, double level, int terms,
         bool straight)
      : around_(around), frame_(frame), level_(level), terms_(terms), straight_(straight) {}

  // `around`: the samples nearest first; `start` of them are the smallest patch.
  PatchFit grow(std::size_t start) {
    taken_.assign(around_.begin(), around_.begin() + static_cast<std::ptrdiff_t>(start));
    double radius = length(around_[start - 1]);
    if (!refit(radius)) return {};
    best_.reach.fill(radius);
    std::array<bool, sectors> open;
    open.fill(true);
    for (std::size_t from = start; from < around_.size();) {
      const std::size_t to = std::min(
          around_.size(), static_cast<std::size_t>(patch_growth * static_cast<double>(from)) + 1);
      const double wider = length(around_[to - 1]);
      const std::vector<Vec3> before = taken_;
      const bool grown = extend(from, to, wider, open);
      if (!grown || !refit(wider)) {
        taken_ = before;
        break;
      }
      for (std::size_t j = 0; j < sectors; ++j)
        if (open[j]) best_.reach[j] = wider;
      from = to;
    }
    return best_;
  }

 private:
  // Fits the samples taken; false, and best_ as it was, if they are not one smooth piece.
  bool refit(double radius) {
    HeightFit fit = fit_heights(frame_, taken_, radius, terms_);
    if (fit.terms == 0 || !explained(fit, taken_, level_)) return false;
    if (straight_ && terms_ == plane_terms && bends(fit, taken_, level_)) return false;
    best_.fit = fit;
    best_.count = static_cast<Index>(taken_.size());
    return true;
  }

  // Takes the samples of the ring in the sectors that continue the fit; closes the others. False
  // if all are closed.
  bool extend(std::size_t from, std::size_t to, double radius, std::array<bool, sectors>& open) {
    std::array<double, sectors> sum{}, squares{}, variance{}, count{};
    const double gate = std::max(other_sheet * radius, least_other_sheet * level_);
    const auto each = [&](auto&& visit) {
      for (std::size_t i = from; i < to; ++i) {
        const Vec3 p = around_[i];
        const std::size_t j = sector_of(p);
        const double r = p.z - best_.fit.height(p.x, p.y);
        if (open[j] && std::abs(r) <= gate) visit(p, j, r);
      }
    };
    each([&](Vec3 p, std::size_t j, double r) {
      const double v = best_.fit.variance(p.x, p.y);
      sum[j] += r;
      squares[j] += r * r / (1 + v);
      variance[j] += v;
      count[j] += 1;
    });
    const double noise = noise_variance(level_);
    bool any = false;
    for (std::size_t j = 0; j < sectors; ++j) {
      const double n = count[j];
      // The errors of the fit at the samples of a sector are all but the same.
      const bool continues =
          n > 0 && squares[j] <= noise * limit(n) &&
          sum[j] * sum[j] <= tolerance * tolerance * noise * (n + n * variance[j]);
      open[j] = open[j] && (continues || (n == 0 && sparse_ring(to - from)));
      any = any || (open[j] && n > 0);
    }
    each([&](Vec3 p, std::size_t, double) { taken_.push_back(p); });
    return any;
  }

  // A sector of so small a ring may be empty by chance.
  static bool sparse_ring(std::size_t samples) { return samples < 3 * sectors; }

  const std::vector<Vec3>& around_;
  Frame frame_;
  double level_;
  int terms_;
  bool straight_;
  std::vector<Vec3> taken_;
  PatchFit best_;
};

// Samples to gather round a point: enough that their mean is wanted_error exact, within bounds.
std::size_t patch_limit(double level, double spacing) {
  const double needed = level / (wanted_error * spacing);
  return static_cast<std::size_t>(
      std::clamp(needed * needed, 4.0 * smallest_patch, static_cast<double>(largest_patch)));
}

// The samples near enough to tell the normal at the centre from: ten, or as many as it takes to be
// wider than the noise.
std::size_t starting_size(const std::vector<Vec3>& around, Vec3 centre, double level) {
  std::size_t n = std::min(smallest_patch, around.size());
  while (n < around.size() && distance(around[n - 1], centre) < least_radius * level) ++n;
  return n;
}

// `around`: in the frame, nearest first.
PatchFit grow(const std::vector<Vec3>& around, const Frame& frame, double level, std::size_t start,
              bool straight) {
  const PatchFit plane = Growth(around, frame, level, plane_terms, straight).grow(start);
  const PatchFit quadric = Growth(around, frame, level, quadric_terms, straight).grow(start);
  return quadric.count > quadric_gain * plane.count ? quadric : plane;
}

PatchFit fit_cloud(const std::vector<Vec3>& points, Vec3 centre, double level,
                   const std::vector<NearestSample::Hit>& hits) {
  std::vector<Vec3> around;
  for (const auto& h : hits) around.push_back(points[h.index]);
  const std::size_t start = starting_size(around, centre, level);
  if (start < smallest_patch) return {};
  const std::vector<Vec3> nearest(around.begin(),
                                  around.begin() + static_cast<std::ptrdiff_t>(start));
  const Frame frame = frame_at(centre, least_variance_direction(nearest));
  for (Vec3& p : around) p = frame.to_frame(p);
  return grow(around, frame, level, start, false);
}

}  // namespace

std::size_t sector_of(Vec3 local) noexcept {
  const bool steep = std::abs(local.x) < std::abs(local.y);
  return (local.x < 0 ? 1u : 0u) + (local.y < 0 ? 2u : 0u) + (steep ? 4u : 0u);
}

bool PatchFit::covers(Vec3 local) const noexcept {
  const double reached = stretch * reach[sector_of(local)];
  return squared_length(local) <= reached * reached;
}

PatchFit fit_patch(const std::vector<Vec3>& local, const Frame& frame, double level) {
  const std::size_t start = starting_size(local, {}, level);
  if (start < smallest_patch) return {};
  return grow(local, frame, level, start, true);
}

std::vector<PatchFit> fit_patches(const std::vector<Vec3>& points, const NearestSample& tree,
                                  const std::vector<double>& level, Job& job) {
  std::vector<PatchFit> fits((points.size() + patch_stride - 1) / patch_stride);
  parallel_chunks(fits.size(), 128, job.threads(), [&](std::size_t begin, std::size_t end) {
    if (job.cancelled()) return;
    std::vector<NearestSample::Hit> hits;
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t i = k * patch_stride;
      if (!(level[i] > 0)) continue;
      tree.nearest(points[i], spacing_rank, hits);
      tree.nearest(points[i], patch_limit(level[i], hits.back().distance), hits);
      fits[k] = fit_cloud(points, points[i], level[i], hits);
    }
  });
  return fits;
}

}  // namespace arris
