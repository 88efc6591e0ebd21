#include "noise/height_fit.h"

#include <cmath>

#include "base/vec.h"
#include "cloud/flatness.h"

namespace arris {
namespace {

// A pivot this small, relative to the number of points, means that they do not determine the fit:
// coordinates are in units of the radius of the patch.
constexpr double smallest_pivot = 1e-6;

void fill_terms(double x, double y, std::array<double, 6>& t) {
  t = {1, x, y, x * x, x * y, y * y};
}

// Solves A c = b in place by Cholesky's factorization of the first `n` rows; false if singular.
bool solve(std::array<std::array<double, 6>, 6>& a, std::array<double, 6>& b, int n, double least) {
  for (int j = 0; j < n; ++j) {
    const auto J = static_cast<std::size_t>(j);
    double pivot = a[J][J];
    for (std::size_t k = 0; k < J; ++k) pivot -= a[J][k] * a[J][k];
    if (!(pivot > least)) return false;
    a[J][J] = std::sqrt(pivot);
    for (std::size_t i = J + 1; i < static_cast<std::size_t>(n); ++i) {
      double s = a[i][J];
      for (std::size_t k = 0; k < J; ++k) s -= a[i][k] * a[J][k];
      a[i][J] = s / a[J][J];
    }
    double s = b[J];
    for (std::size_t k = 0; k < J; ++k) s -= a[J][k] * b[k];
    b[J] = s / a[J][J];
  }
  for (int j = n - 1; j >= 0; --j) {
    const auto J = static_cast<std::size_t>(j);
    for (std::size_t k = J + 1; k < static_cast<std::size_t>(n); ++k) b[J] -= a[k][J] * b[k];
    b[J] /= a[J][J];
  }
  return true;
}

}  // namespace

Vec3 Frame::to_frame(Vec3 p) const noexcept {
  const Vec3 d = p - origin;
  return {dot(d, x), dot(d, y), dot(d, z)};
}

Frame frame_at(Vec3 origin, Vec3 normal) {
  const double ax = std::abs(normal.x), ay = std::abs(normal.y), az = std::abs(normal.z);
  const Vec3 least = ax <= ay && ax <= az ? Vec3{1, 0, 0}
                     : ay <= az           ? Vec3{0, 1, 0}
                                          : Vec3{0, 0, 1};
  const Vec3 x = normalized(cross(normal, least));
  return {origin, x, cross(normal, x), normal};
}

Vec3 least_variance_direction(const std::vector<Vec3>& points) {
  return points.size() < 3 ? Vec3{0, 0, 1} : flatness(points).normal;
}

double HeightFit::height(double x, double y) const noexcept {
  x /= radius;
  y /= radius;
  return c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y;
}

double HeightFit::variance(double x, double y) const noexcept {
  std::array<double, 6> t{};
  fill_terms(x / radius, y / radius, t);
  double sum = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(terms); ++i) {
    for (std::size_t k = 0; k < i; ++k) t[i] -= factor[i][k] * t[k];
    t[i] /= factor[i][i];
    sum += t[i] * t[i];
  }
  return sum;
}

HeightFit::Offset HeightFit::offset(Vec3 p) const noexcept {
  const Vec3 q = frame.to_frame(p);
  const double x = q.x / radius, y = q.y / radius;
  const double fx = (c[1] + 2 * c[3] * x + c[4] * y) / radius;
  const double fy = (c[2] + c[4] * x + 2 * c[5] * y) / radius;
  const double stretch = 1 / std::sqrt(1 + fx * fx + fy * fy);
  return {(q.z - height(q.x, q.y)) * stretch, stretch * (frame.z - fx * frame.x - fy * frame.y)};
}

HeightFit fit_heights(const Frame& frame, const std::vector<Vec3>& local, double radius,
                      int terms) {
  HeightFit fit{frame, radius, {}, 0, {}};
  if (local.size() < static_cast<std::size_t>(terms)) return fit;
  std::array<std::array<double, 6>, 6> a{};
  std::array<double, 6> b{}, t{};
  const auto n = static_cast<std::size_t>(terms);
  for (Vec3 p : local) {
    fill_terms(p.x / radius, p.y / radius, t);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j <= i; ++j) a[i][j] += t[i] * t[j];
      b[i] += t[i] * p.z;
    }
  }
  if (!solve(a, b, terms, smallest_pivot * static_cast<double>(local.size()))) return fit;
  for (std::size_t i = 0; i < n; ++i) fit.c[i] = b[i];
  fit.terms = terms;
  fit.factor = a;
  return fit;
}

double residual_deviation(const HeightFit& fit, const std::vector<Vec3>& local) {
  double sum = 0;
  for (Vec3 p : local) {
    const double r = p.z - fit.height(p.x, p.y);
    sum += r * r;
  }
  const double freedom = static_cast<double>(local.size()) - fit.terms;
  return freedom > 0 ? std::sqrt(sum / freedom) : 0;
}

}  // namespace arris
