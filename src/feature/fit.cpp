#include "feature/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

template <std::size_t N>
void add_to(NormalEquations<N>& sums, double x, double y, double z, double w) {
  const std::array<double, 6> t = {1, x, y, x * x, x * y, y * y};
  for (std::size_t i = 0; i < N; ++i) {
    const double wt = w * t[i];
    for (std::size_t j = 0; j <= i; ++j) sums.a[i][j] += wt * t[j];
    sums.b[i] += wt * z;
  }
}

// Of the first N unknowns, by a root-free Cholesky factorization a = L D L^T; what the members
// leave open is zero, and so are the others.
template <std::size_t N, std::size_t M>
std::array<double, 6> solve(const NormalEquations<M>& sums) {
  std::array<std::array<double, N>, N> scaled, lower;  // L D and L, below the diagonal
  std::array<double, N> inverse, b;
  for (std::size_t j = 0; j < N; ++j) {
    const double diagonal = sums.a[j][j] + (j < 3 ? 0 : ridge * sums.a[0][0]);
    double pivot = diagonal;
    for (std::size_t k = 0; k < j; ++k) pivot -= scaled[j][k] * lower[j][k];
    inverse[j] = pivot > least_pivot * diagonal ? 1 / pivot : 0;
    for (std::size_t i = j + 1; i < N; ++i) {
      scaled[i][j] = sums.a[i][j];
      for (std::size_t k = 0; k < j; ++k) scaled[i][j] -= scaled[i][k] * lower[j][k];
      lower[i][j] = scaled[i][j] * inverse[j];
    }
  }
  for (std::size_t i = 0; i < N; ++i) {
    b[i] = sums.b[i];
    for (std::size_t k = 0; k < i; ++k) b[i] -= lower[i][k] * b[k];
  }
  std::array<double, 6> c{};
  for (std::size_t i = N; i-- > 0;) {
    c[i] = b[i] * inverse[i];
    for (std::size_t k = i + 1; k < N; ++k) c[i] -= lower[k][i] * c[k];
  }
  return c;
}

void set_coefficients(const std::array<double, 6>& c, double h, LocalSurface& s) {
  s.c = {c[0] * h, c[1], c[2], c[3] / h, c[4] / h, c[5] / h};
}

}  // namespace

void PatchFit::start(const LocalSurface& surface, double h, double roughness) {
  frame_ = surface;
  h_ = h;
  roughness_ = roughness;
  for (auto* per_member : {&x_, &y_, &z_, &weight_}) per_member->clear();
  sums_ = {};
}

void PatchFit::add(Vec3 p, double weight) {
  const Vec3 d = (1 / h_) * (p - frame_.origin);
  x_.push_back(dot(d, frame_.u));
  y_.push_back(dot(d, frame_.v));
  z_.push_back(dot(d, frame_.n));
  weight_.push_back(weight);
  add_to(sums_, x_.back(), y_.back(), z_.back(), weight);
}

void PatchFit::fit(Form form, LocalSurface& surface) const {
  set_coefficients(form == Form::plane ? solve<3>(sums_) : solve<6>(sums_), h_, surface);
}

void PatchFit::fit_robustly(LocalSurface& surface) {
  residual_.resize(x_.size());
  if (!run<3>()) run<6>();
  set_coefficients(c_, h_, surface);
}

template <std::size_t N>
bool PatchFit::run() {
  c_ = solve<N>(sums_);
  constexpr bool plane = N == 3;
  const double floor = std::max(exact, roughness_ / h_);
  for (int step = 0; step < (plane ? plane_steps : quadric_steps); ++step) {
    measure<N>();
    if (*std::max_element(residual_.begin(), residual_.end()) <= floor) return true;
    const double median = median_residual();
    if (plane && step == 1 && median > std::max(curved, 2 * floor)) return false;
    refit<N>(bisquare * std::max(median, floor));
  }
  return !plane || is_plane();
}

// Distances of the members, to first order.
template <std::size_t N>
void PatchFit::measure() {
  const auto& c = c_;
  const double flat = std::sqrt(1 + c[1] * c[1] + c[2] * c[2]);
  for (std::size_t k = 0; k < residual_.size(); ++k) {
    const double x = x_[k], y = y_[k], z = z_[k];
    if (N == 3) {
      residual_[k] = std::abs(z - (c[0] + c[1] * x + c[2] * y)) / flat;
      continue;
    }
    const double zx = c[1] + 2 * c[3] * x + c[4] * y, zy = c[2] + c[4] * x + 2 * c[5] * y;
    const double height = c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y;
    residual_[k] = std::abs(z - height) / std::sqrt(1 + zx * zx + zy * zy);
  }
}

// With weights that fall to nothing where residuals reach `width`.
template <std::size_t N>
void PatchFit::refit(double width) {
  NormalEquations<N> sums;
  for (std::size_t k = 0; k < residual_.size(); ++k) {
    const double r = std::min(residual_[k] / width, 1.0), one = 1 - r * r;
    const double weight = weight_[k] * (one * one + 1e-9);  // never a singular system
    add_to(sums, x_[k], y_[k], z_[k], weight);
  }
  c_ = solve<N>(sums);
}

// Between bounds that close in: for as few values as a patch has, counting is faster than moving
// them, as it takes no branches.
double PatchFit::median_residual() const {
  const auto rank = static_cast<std::ptrdiff_t>(residual_.size() / 2);
  double median = -1, above = std::numeric_limits<double>::infinity();
  for (const double pivot : residual_) {
    if (pivot <= median || pivot >= above) continue;
    std::ptrdiff_t less = 0;
    for (const double r : residual_) less += r < pivot;
    if (less == rank) return pivot;
    (less < rank ? median : above) = pivot;  // of equal ones the largest that has few enough below
  }
  return median >= 0 ? median : above;  // of what is no number
}

bool PatchFit::is_plane() {
  measure<3>();
  const double near = std::max(10 * exact, 2 * roughness_ / h_);
  const auto on =
      std::count_if(residual_.begin(), residual_.end(), [&](double r) { return r <= near; });
  return static_cast<double>(on) >= plane_share * static_cast<double>(residual_.size());
}

}  // namespace arris
