#include "cloud/flatness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vec.h"

namespace arris {
namespace {

// A symmetric 3 x 3 matrix and the axes found so far, for Jacobi's method.
struct Jacobi {
  std::array<std::array<double, 3>, 3> a{};
  std::array<std::array<double, 3>, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // columns

  // Turns in the plane of axes p and q so that a[p][q] becomes zero.
  void rotate(std::size_t p, std::size_t q) {
    if (a[p][q] == 0) return;
    const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double t = std::copysign(1 / (std::abs(theta) + std::sqrt(theta * theta + 1)), theta);
    const double c = 1 / std::sqrt(t * t + 1), s = t * c;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = a[k][p], y = a[k][q];
      a[k][p] = c * x - s * y;
      a[k][q] = s * x + c * y;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = a[p][k], y = a[q][k];
      a[p][k] = c * x - s * y;
      a[q][k] = s * x + c * y;
    }
    for (auto& row : axes) {
      const double x = row[p], y = row[q];
      row[p] = c * x - s * y;
      row[q] = s * x + c * y;
    }
  }
};

// Sweeps of Jacobi's method converge quadratically; 3 x 3 matrices need four to six.
constexpr int sweeps = 8;

}  // namespace

Flatness flatness(std::span<const Vec3> points) {
  Vec3 mean;
  for (Vec3 p : points) mean = mean + p;
  const double share = 1 / static_cast<double>(points.size());
  mean = share * mean;
  Jacobi m;
  for (Vec3 p : points) {
    const Vec3 d = p - mean;
    const std::array<double, 3> x = {d.x, d.y, d.z};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) m.a[i][j] += share * x[i] * x[j];
  }
  for (int k = 0; k < sweeps; ++k) {
    m.rotate(0, 1);
    m.rotate(0, 2);
    m.rotate(1, 2);
  }
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return m.a[i][i] < m.a[j][j]; });
  const std::size_t n = order[0];
  const Vec3 normal = {m.axes[0][n], m.axes[1][n], m.axes[2][n]};
  return {normal, std::max(0.0, m.a[n][n]), std::max(0.0, m.a[order[1]][order[1]])};
}

}  // namespace arris
