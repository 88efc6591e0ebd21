#include "feature/jet.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "feature/local_surface.h"

namespace arris {
namespace {

using Terms = Eigen::Matrix<double, 10, 1>;
using Normal = Eigen::Matrix<double, 10, 10>;

// Width of the Gaussian, in units of `unit`. Widths of 0.75 to 2 bring the same within a few
// percent.
constexpr double width = 1;
// Ridges on second and third derivatives: nothing against what well spread members say.
constexpr double ridge_second = 1e-4, ridge_third = 1e-3;

Terms terms(double x, double y) {
  return {1, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y};
}

}  // namespace

double Jet::height(Vec3 p) const noexcept {
  const Vec3 d = (1 / unit) * (p - origin);
  const Terms t = terms(dot(d, u), dot(d, v));
  double z = 0;
  for (std::size_t k = 0; k < c.size(); ++k) z += c[k] * t[static_cast<Eigen::Index>(k)];
  return unit * z;
}

Vec3 Jet::normal() const noexcept {
  return normalized(n - c[1] * u - c[2] * v);
}

Jet fit_jet(const std::vector<Vec3>& points, const std::vector<Index>& members, Vec3 origin, Vec3 n,
            double unit) {
  const LocalSurface frame = tangent_plane(origin, n);
  Jet jet{origin, frame.u, frame.v, n, unit, {}};
  Normal a = Normal::Zero();
  Terms b = Terms::Zero();
  std::vector<double> weight;
  double all = 0;
  for (Index m : members) {
    const Vec3 d = (1 / unit) * (points[m] - origin);
    const double w = std::exp(-squared_length(d) / (2 * width * width));
    const Terms t = terms(dot(d, jet.u), dot(d, jet.v));
    all += w;
    weight.push_back(w);
    b.noalias() += w * dot(d, n) * t;
    a.noalias() += w * t * t.transpose();
  }
  for (Eigen::Index k = 3; k < 10; ++k) a(k, k) += (k < 6 ? ridge_second : ridge_third) * all;
  const Terms c = a.ldlt().solve(b);
  for (std::size_t k = 0; k < jet.c.size(); ++k) jet.c[k] = c[static_cast<Eigen::Index>(k)];
  double sum = 0;
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Vec3 p = points[members[k]];
    const double r = dot(p - origin, n) - jet.height(p);
    sum += weight[k] * r * r;
  }
  const double count = static_cast<double>(members.size());
  jet.residual = std::sqrt(sum / all * count / std::max(count - 10, 1.0));
  return jet;
}

}  // namespace arris
