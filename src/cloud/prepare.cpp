#include "cloud/prepare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "base/failure.h"
#include "base/vec.h"

namespace arris {
namespace {

std::string show(Vec3 p) {
  const auto text = [](double c) { return std::isnan(c) ? std::string("nan") : std::to_string(c); };
  return "(" + text(p.x) + ", " + text(p.y) + ", " + text(p.z) + ")";
}

std::vector<Index> finite_indices(const std::vector<Vec3>& positions, NonFinite policy) {
  std::vector<Index> kept;
  kept.reserve(positions.size());
  std::size_t bad = 0, first_bad = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (is_finite(positions[i]))
      kept.push_back(static_cast<Index>(i));
    else if (bad++ == 0)
      first_bad = i;
  }
  if (bad > 0 && policy == NonFinite::refuse)
    throw Failure(ErrorCode::bad_points,
                  std::to_string(bad) + " of " + std::to_string(positions.size()) +
                      " points have a coordinate that is not finite; the first is point " +
                      std::to_string(first_bad) + ": " + show(positions[first_bad]),
                  "drop them with --drop-non-finite (Options::non_finite), or clean the file");
  return kept;
}

// Shift for one axis with values in [low, high]: their middle if every subtraction is exact.
double exact_shift(double low, double high) {
  const double middle = 0.5 * low + 0.5 * high;
  const double near = std::min(std::abs(low), std::abs(high));
  const double far = std::max(std::abs(low), std::abs(high));
  const bool same_sign = (low > 0) == (high > 0) && low != 0 && high != 0;
  return same_sign && near >= 0.5 * std::abs(middle) && far <= 2 * std::abs(middle) ? middle : 0;
}

LocalFrame choose_frame(const std::vector<Vec3>& positions, const std::vector<Index>& kept) {
  Vec3 low = positions[kept[0]], high = low;
  for (Index i : kept) {
    const Vec3 p = positions[i];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  LocalFrame frame;
  frame.shift = {exact_shift(low.x, high.x), exact_shift(low.y, high.y),
                 exact_shift(low.z, high.z)};
  // Largest half extent decides the scale; halves so that 1e308 - -1e308 does not overflow.
  const double extent = std::max(
      {std::abs(0.5 * low.x - 0.5 * frame.shift.x), std::abs(0.5 * high.x - 0.5 * frame.shift.x),
       std::abs(0.5 * low.y - 0.5 * frame.shift.y), std::abs(0.5 * high.y - 0.5 * frame.shift.y),
       std::abs(0.5 * low.z - 0.5 * frame.shift.z), std::abs(0.5 * high.z - 0.5 * frame.shift.z)});
  if (extent > 0) {
    // Clamped so that scale itself and 1/scale stay normal numbers.
    const int exponent = std::clamp(-std::ilogb(extent) - 2, -1021, 1021);
    frame.scale = std::ldexp(1.0, exponent);
  }
  return frame;
}

// A sample on its way into canonical order: along a Morton curve, so that neighbours in space are
// neighbours in memory, and lexicographically within a cell of the curve.
struct Entry {
  std::uint64_t key;
  Vec3 local;
  Index source;
};

// Spreads the low 21 bits of x to every third bit.
std::uint64_t spread_bits(std::uint64_t x) {
  x = (x | x << 32) & 0x001F00000000FFFF;
  x = (x | x << 16) & 0x001F0000FF0000FF;
  x = (x | x << 8) & 0x100F00F00F00F00F;
  x = (x | x << 4) & 0x10C30C30C30C30C3;
  return (x | x << 2) & 0x1249249249249249;
}

// The local frame keeps coordinates within [-1, 1]: 21 bits an axis. (Within [-8, 8] at the end of
// the exponent range, where the curve is only less local.)
std::uint64_t morton_key(Vec3 local) {
  const auto cell = [](double c) {
    return static_cast<std::uint64_t>(std::clamp((c + 1) * 0x1p20, 0.0, 0x1p21 - 1));
  };
  return spread_bits(cell(local.x)) | spread_bits(cell(local.y)) << 1 |
         spread_bits(cell(local.z)) << 2;
}

bool along_curve(const Entry& a, const Entry& b) {
  if (a.key != b.key) return a.key < b.key;
  if (!(a.local == b.local)) return lexicographic_less(a.local, b.local);
  return a.source < b.source;
}

}  // namespace

Samples prepare_samples(const std::vector<Vec3>& positions, NonFinite policy, Job& job) {
  if (positions.size() >= no_index - 1)
    throw Failure(
        ErrorCode::out_of_memory,
        std::to_string(positions.size()) + " points are more than 32-bit indices can name",
        "use fewer points, or split the cloud");
  std::vector<Index> kept = finite_indices(positions, policy);
  if (kept.empty())
    throw Failure(ErrorCode::bad_points, "the cloud has no finite points", "give at least four");
  Samples samples;
  samples.non_finite = positions.size() - kept.size();
  samples.frame = choose_frame(positions, kept);
  job.tick(0.2);

  std::vector<Entry> entries(kept.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const Vec3 local = samples.frame.to_local(positions[kept[k]]);
    entries[k] = {morton_key(local), {local.x + 0.0, local.y + 0.0, local.z + 0.0}, kept[k]};
  }
  kept = {};
  std::sort(entries.begin(), entries.end(), along_curve);
  job.tick(0.8);
  const auto last = std::unique(entries.begin(), entries.end(),
                                [](const Entry& a, const Entry& b) { return a.local == b.local; });
  const auto distinct = static_cast<std::size_t>(last - entries.begin());
  samples.duplicates = entries.size() - distinct;
  samples.points.resize(distinct);
  samples.source.resize(distinct);
  for (std::size_t k = 0; k < distinct; ++k) {
    samples.points[k] = entries[k].local;
    samples.source[k] = entries[k].source;
  }
  if (distinct < 4)
    throw Failure(ErrorCode::degenerate,
                  std::to_string(distinct) + " distinct point" + (distinct == 1 ? "" : "s") +
                      " of " + std::to_string(positions.size()) + " bound no volume",
                  "give at least four points that are not in one plane");
  return samples;
}

void replace_points(const std::vector<Vec3>& points, Samples& samples) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return points[a] == points[b] ? a < b : lexicographic_less(points[a], points[b]);
  });
  std::vector<bool> repeated(points.size(), false);
  for (std::size_t k = 1; k < order.size(); ++k)
    repeated[order[k]] = points[order[k]] == points[order[k - 1]];
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (repeated[i]) continue;
    samples.points[kept] = {points[i].x + 0.0, points[i].y + 0.0, points[i].z + 0.0};
    samples.source[kept++] = samples.source[i];
  }
  samples.duplicates += points.size() - kept;
  samples.points.resize(kept);
  samples.source.resize(kept);
}

}  // namespace arris
