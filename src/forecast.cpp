#include "forecast.h"

#include <cmath>
#include <string>

#include "arris/reconstruct.h"
#include "base/failure.h"
#include "base/job.h"

namespace arris {
namespace {

// Bytes a point: the peak lies in the Delaunay stage and in the cut. Measured at 10k to 1M points
// (docs/measurements.md), rounded up; the fixed part is the program itself.
constexpr double bytes_per_sample = 1200;
constexpr double bytes_per_background_point = 1200;
// While points are added the mesh before and what is sensed of its surface are held, too: 1630
// bytes a point in all, beyond the fixed part, for 100k random points of a bolt.
constexpr double bytes_to_sharpen = 900;
// Points are added twice, while both meshes are held: 12 kB a point in all for 6,000 points of a
// model with 9.8 added to each; less where samples are dense and the second round finds little.
constexpr double bytes_to_refine = 9 * 1200;
constexpr double bytes_fixed = 32e6;

std::string in_gigabytes(double bytes) {
  return std::to_string(std::round(bytes / 1e7) / 100).substr(0, 5) + " GB";
}

}  // namespace

std::size_t forecast_memory(std::size_t points, const Options& options) {
  double background = options.background;
  if (!(background >= 0)) background = options.method == Method::paper ? 10 : 0;
  const bool sharpen = options.sharpen && options.method != Method::paper;
  const bool refine = options.refine && options.method != Method::paper;
  const double each = bytes_per_sample + background * bytes_per_background_point +
                      (sharpen ? bytes_to_sharpen : 0) + (refine ? bytes_to_refine : 0);
  return static_cast<std::size_t>(bytes_fixed + static_cast<double>(points) * each);
}

void require_memory(std::size_t points, const Options& options, const Context& context) {
  const std::size_t need = forecast_memory(points, options);
  const std::uint64_t machine = machine_memory();
  const bool limited = context.memory_limit > 0;
  const std::uint64_t limit = limited ? context.memory_limit : machine;
  if (limit == 0 || need <= limit) return;
  throw Failure(ErrorCode::out_of_memory,
                std::to_string(points) + " points need about " +
                    in_gigabytes(static_cast<double>(need)) + ", more than the " +
                    (limited ? "limit of " : "memory of ") +
                    in_gigabytes(static_cast<double>(limit)),
                limited ? "raise the memory limit, or thin the cloud"
                        : "thin the cloud, split it, or use a machine with more memory");
}

}  // namespace arris
