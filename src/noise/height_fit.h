// A plane or a quadric as a height over a tangent frame, fitted by least squares.
// Such fits ("jets") are those of Cazals and Pouget, Estimating differential quantities using
// polynomial fitting of osculating jets (2005).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "arris/types.h"

namespace arris {

// A right-handed orthonormal frame; z is the normal.
struct Frame {
  Vec3 origin, x, y, z;

  Vec3 to_frame(Vec3 p) const noexcept;
};

// A frame with the given unit normal; x and y depend on the normal alone.
Frame frame_at(Vec3 origin, Vec3 normal);

// Direction of least variance of the points about their mean, a unit vector; (0, 0, 1) for fewer
// than three points. Its sign is arbitrary.
Vec3 least_variance_direction(const std::vector<Vec3>& points);

inline constexpr int plane_terms = 3, quadric_terms = 6;

// f(x, y) = c0 + c1 x + c2 y (+ c3 x² + c4 xy + c5 y²), x and y in units of `radius`, f in that of
// the points. terms is 0 where no fit was possible.
struct HeightFit {
  Frame frame;
  double radius = 1;
  std::array<double, 6> c{};
  int terms = 0;
  std::array<std::array<double, 6>, 6> factor{};  // Cholesky factor of the normal equations

  double height(double x, double y) const noexcept;  // unscaled x, y
  // Variance of that height, in units of the variance of one sample.
  double variance(double x, double y) const noexcept;

  // The signed distance of a point to the surface along the surface normal below it (first order),
  // and that unit normal.
  struct Offset {
    double distance = 0;
    Vec3 normal;
  };
  Offset offset(Vec3 p) const noexcept;
};

// Fits `terms` coefficients to points given in the coordinates of the frame. The fit has terms = 0
// if the points do not determine it. O(points).
HeightFit fit_heights(const Frame& frame, const std::vector<Vec3>& local, double radius, int terms);

// Root mean square of the residuals, per degree of freedom: an unbiased deviation of the noise if
// the surface is of the fitted kind.
double residual_deviation(const HeightFit& fit, const std::vector<Vec3>& local);

}  // namespace arris
