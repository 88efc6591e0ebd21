#include "feature/fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace arris {
namespace {

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
// A pivot below this share of its diagonal is rounding: members on a line do not say how the
// surface turns about it.
constexpr double least_pivot = 1e-13;

using Coefficients = std::array<double, 6>;  // of a height field in units of h

// A member in the frame of the surface, in units of h.
struct Local {
  double x, y, z;
};

Local to_local(const FitData& data, const LocalSurface& s, std::size_t member) {
  const Vec3 d = (1 / data.h) * (data.points[data.members[member]] - s.origin);
  return {dot(d, s.u), dot(d, s.v), dot(d, s.n)};
}

void set_coefficients(const Coefficients& c, double h, LocalSurface& s) {
  s.c = {c[0] * h, c[1], c[2], c[3] / h, c[4] / h, c[5] / h};
}

// Normal equations of the first N of the monomials 1, x, y, x², xy, y²: 3 make a plane.
template <std::size_t N>
class LeastSquares {
 public:
  void add(const Local& p, double w) {
    const Coefficients t = {1, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y};
    for (std::size_t i = 0; i < N; ++i) {
      const double wt = w * t[i];
      for (std::size_t j = 0; j <= i; ++j) a_[i][j] += wt * t[j];
      b_[i] += wt * p.z;
    }
  }

  // By a root-free Cholesky factorization; what the members leave open is zero.
  Coefficients solve() {
    for (std::size_t k = 3; k < N; ++k) a_[k][k] += ridge * a_[0][0];
    std::array<double, N> inverse;
    for (std::size_t j = 0; j < N; ++j) {
      double pivot = a_[j][j];
      for (std::size_t k = 0; k < j; ++k) pivot -= a_[j][k] * scaled_[j][k];
      inverse[j] = pivot > least_pivot * a_[j][j] ? 1 / pivot : 0;
      for (std::size_t i = j + 1; i < N; ++i) {
        for (std::size_t k = 0; k < j; ++k) a_[i][j] -= a_[i][k] * scaled_[j][k];
        scaled_[i][j] = a_[i][j] * inverse[j];
      }
    }
    return substitute(inverse);
  }

 private:
  // a = L D L^T with L in scaled_ and L D in a_, below the diagonal.
  Coefficients substitute(const std::array<double, N>& inverse) {
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t k = 0; k < i; ++k) b_[i] -= scaled_[i][k] * b_[k];
    Coefficients c{};
    for (std::size_t i = N; i-- > 0;) {
      c[i] = b_[i] * inverse[i];
      for (std::size_t k = i + 1; k < N; ++k) c[i] -= scaled_[k][i] * c[k];
    }
    return c;
  }

  std::array<std::array<double, N>, N> a_{}, scaled_{};
  std::array<double, N> b_{};
};

// Iteratively reweighted fits to members whose places in the frame are computed once.
class RobustFit {
 public:
  RobustFit(const FitData& data, const LocalSurface& s)
      : data_(data), place_(data.members.size()), residual_(place_.size()), weight_(data.weight) {
    for (std::size_t k = 0; k < place_.size(); ++k) place_[k] = to_local(data, s, k);
  }

  const Coefficients& coefficients() const noexcept { return c_; }

  // From the least squares fit on. Returns, of a plane, whether most members lie on it exactly.
  template <std::size_t N>
  bool run() {
    weight_ = data_.weight;
    fit<N>();
    constexpr bool plane = N == 3;
    const double floor = std::max(exact, data_.roughness / data_.h);
    for (int step = 0; step < (plane ? plane_steps : quadric_steps); ++step) {
      measure<N>();
      const double median = median_residual();
      if (plane && step == 1 && median > std::max(curved, 2 * floor)) return false;
      if (*std::max_element(residual_.begin(), residual_.end()) <= floor) return true;
      reweight(bisquare * std::max(median, floor));
      fit<N>();
    }
    return !plane || is_plane();
  }

 private:
  template <std::size_t N>
  void fit() {
    LeastSquares<N> sums;
    for (std::size_t k = 0; k < place_.size(); ++k) sums.add(place_[k], weight_[k]);
    c_ = sums.solve();
  }

  // Distances of the members, to first order.
  template <std::size_t N>
  void measure() {
    const double flat = std::sqrt(1 + c_[1] * c_[1] + c_[2] * c_[2]);
    for (std::size_t k = 0; k < place_.size(); ++k) {
      const auto& [x, y, z] = place_[k];
      if (N == 3) {
        residual_[k] = std::abs(z - (c_[0] + c_[1] * x + c_[2] * y)) / flat;
        continue;
      }
      const double zx = c_[1] + 2 * c_[3] * x + c_[4] * y, zy = c_[2] + c_[4] * x + 2 * c_[5] * y;
      const double height =
          c_[0] + c_[1] * x + c_[2] * y + c_[3] * x * x + c_[4] * x * y + c_[5] * y * y;
      residual_[k] = std::abs(z - height) / std::sqrt(1 + zx * zx + zy * zy);
    }
  }

  double median_residual() {
    scratch_ = residual_;
    const auto middle = scratch_.begin() + static_cast<std::ptrdiff_t>(scratch_.size() / 2);
    std::nth_element(scratch_.begin(), middle, scratch_.end());
    return *middle;
  }

  void reweight(double width) {
    for (std::size_t k = 0; k < weight_.size(); ++k) {
      const double r = std::min(residual_[k] / width, 1.0), one = 1 - r * r;
      weight_[k] = data_.weight[k] * (one * one + 1e-9);  // never a singular system
    }
  }

  bool is_plane() {
    measure<3>();
    const double near = std::max(10 * exact, 2 * data_.roughness / data_.h);
    const auto on =
        std::count_if(residual_.begin(), residual_.end(), [&](double r) { return r <= near; });
    return static_cast<double>(on) >= plane_share * static_cast<double>(residual_.size());
  }

  const FitData& data_;
  std::vector<Local> place_;
  std::vector<double> residual_, weight_, scratch_;
  Coefficients c_{};
};

template <std::size_t N>
Coefficients least_squares(const FitData& data, const LocalSurface& s) {
  LeastSquares<N> sums;
  for (std::size_t k = 0; k < data.members.size(); ++k)
    sums.add(to_local(data, s, k), data.weight[k]);
  return sums.solve();
}

}  // namespace

void fit(const FitData& data, Form form, LocalSurface& surface) {
  set_coefficients(
      form == Form::plane ? least_squares<3>(data, surface) : least_squares<6>(data, surface),
      data.h, surface);
}

void fit_robustly(const FitData& data, LocalSurface& surface) {
  RobustFit robust(data, surface);
  if (!robust.run<3>()) robust.run<6>();
  set_coefficients(robust.coefficients(), data.h, surface);
}

}  // namespace arris
