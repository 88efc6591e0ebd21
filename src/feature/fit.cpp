#include "feature/fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace arris {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

// Ridge on second derivatives: nothing against what well spread members say, a plane otherwise.
constexpr double ridge = 1e-3;
// Residuals below this (in units of spacing) are those of a sample exactly on a plane: coordinates
// in single precision round at a thousandth of it.
constexpr double exact = 1e-4;
// A plane if this share of the members lie on it to ten times that.
constexpr double plane_share = 0.6;
// No plane if, after the first step, half of the members are farther off than this.
constexpr double curved = 0.02;
// A plane among outliers takes more steps than a quadric, which follows them.
constexpr int plane_steps = 6, quadric_steps = 3;
// Bisquare width in units of the median residual, at which normal residuals keep 95 % efficiency
// (4.685 standard deviations, 0.6745 of which is the median).
constexpr double bisquare = 4.685 / 1.4826;

void fit_weighted(const FitData& data, const std::vector<double>& weight, Form form,
                  LocalSurface& s) {
  Matrix6 a = Matrix6::Zero();
  Vector6 b = Vector6::Zero();
  double all = 0;
  for (std::size_t k = 0; k < data.members.size(); ++k) {
    const Vec3 d = (1 / data.h) * (data.points[data.members[k]] - s.origin);
    const double x = dot(d, s.u), y = dot(d, s.v), w = weight[k];
    const Vector6 t{1, x, y, x * x, x * y, y * y};
    all += w;
    b.noalias() += w * dot(d, s.n) * t;
    if (form == Form::plane) {
      a.topLeftCorner<3, 3>().noalias() += w * t.head<3>() * t.head<3>().transpose();
    } else {
      a.noalias() += w * t * t.transpose();
    }
  }
  s.c = {};
  if (form == Form::plane) {
    const Eigen::Vector3d c = a.topLeftCorner<3, 3>().ldlt().solve(b.head<3>());
    s.c = {c[0] * data.h, c[1], c[2], 0, 0, 0};
  } else {
    for (int k = 3; k < 6; ++k) a(k, k) += ridge * all;
    const Vector6 c = a.ldlt().solve(b);
    s.c = {c[0] * data.h, c[1], c[2], c[3] / data.h, c[4] / data.h, c[5] / data.h};
  }
}

// Residuals of the members in units of h, in scratch the same sorted up to the median.
double median_residual(const FitData& data, const LocalSurface& s, std::vector<double>& residual,
                       std::vector<double>& scratch) {
  residual.resize(data.members.size());
  for (std::size_t k = 0; k < residual.size(); ++k)
    residual[k] = std::abs(s.distance(data.points[data.members[k]])) / data.h;
  scratch = residual;
  const auto middle = scratch.begin() + static_cast<std::ptrdiff_t>(scratch.size() / 2);
  std::nth_element(scratch.begin(), middle, scratch.end());
  return *middle;
}

// Returns, of a plane, whether most members lie on it exactly.
bool reweight(const FitData& data, Form form, LocalSurface& s) {
  std::vector<double> residual, scratch, weight(data.members.size());
  const int steps = form == Form::plane ? plane_steps : quadric_steps;
  for (int step = 0; step < steps; ++step) {
    const double median = median_residual(data, s, residual, scratch);
    if (form == Form::plane && step == 1 && median > curved) return false;
    if (*std::max_element(residual.begin(), residual.end()) <= exact) return true;
    const double width = bisquare * std::max(median, exact);
    for (std::size_t k = 0; k < weight.size(); ++k) {
      const double r = std::min(residual[k] / width, 1.0), one = 1 - r * r;
      weight[k] = data.weight[k] * (one * one + 1e-9);  // never a singular system
    }
    fit_weighted(data, weight, form, s);
  }
  if (form == Form::quadric) return true;
  median_residual(data, s, residual, scratch);
  const auto on =
      std::count_if(residual.begin(), residual.end(), [](double r) { return r <= 10 * exact; });
  return static_cast<double>(on) >= plane_share * static_cast<double>(residual.size());
}

}  // namespace

void fit(const FitData& data, Form form, LocalSurface& surface) {
  fit_weighted(data, data.weight, form, surface);
}

void fit_robustly(const FitData& data, LocalSurface& surface) {
  fit(data, Form::plane, surface);
  if (reweight(data, Form::plane, surface)) return;
  fit(data, Form::quadric, surface);
  reweight(data, Form::quadric, surface);
}

}  // namespace arris
