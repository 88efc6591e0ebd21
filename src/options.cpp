#include "options.h"

#include <cmath>
#include <limits>
#include <string>

#include "base/failure.h"

namespace arris {
namespace {

// The paper's settings (its section 5 and table 1).
constexpr int paper_cycles = 3;
constexpr double paper_background = 10;

// Without background points every point lies on the surface, so its signed distance carries no
// curvature and a second cut would equal the first. Nor does any surface's, if λ weighs area.
constexpr int automatic_cycles = 1;

constexpr int most_cycles = 100;
constexpr double most_background = 1000;

[[noreturn]] void refuse(const char* option, const std::string& value, const char* range) {
  throw Failure(ErrorCode::usage, std::string(option) + " is " + value + ", which is out of range",
                std::string("give ") + range);
}

}  // namespace

Options resolve_options(Options options) {
  const bool paper = options.method == Method::paper;
  if (!(options.lambda >= 0) || !std::isfinite(options.lambda))
    refuse("lambda", std::to_string(options.lambda), "a finite number of at least 0");
  if (options.cycles < 0 || options.cycles > most_cycles)
    refuse("cycles", std::to_string(options.cycles), "1 to 100, or 0 for the default");
  if (!(options.background <= most_background))
    refuse("background", std::to_string(options.background), "at most 1000 points per sample");
  if (std::isnan(options.noise) || options.noise == std::numeric_limits<double>::infinity())
    refuse("noise", std::to_string(options.noise), "a length of at least 0, or less for automatic");
  if (options.noise < 0) options.noise = paper ? 0 : -1;
  const bool area = options.curvature == Curvature::area;
  if (options.cycles == 0) options.cycles = paper && !area ? paper_cycles : automatic_cycles;
  if (options.background < 0) options.background = paper ? paper_background : 0;
  if (options.curvature == Curvature::by_method)
    options.curvature = paper ? Curvature::cotangent : Curvature::polyhedral;
  options.sharpen = options.sharpen && !paper;
  options.refine = options.refine && !paper;
  if (options.outliers == Outliers::by_method)
    options.outliers = paper ? Outliers::keep : Outliers::drop;
  return options;
}

}  // namespace arris
