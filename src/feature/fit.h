// Least squares and robust fits of a LocalSurface to the members of a patch.
#pragma once

#include <array>
#include <vector>

#include "feature/local_surface.h"

namespace arris {

enum class Form : std::uint8_t { plane, quadric };

// Normal equations of heights z over the first N of the monomials 1, x, y, x², xy, y²: 3 make a
// plane. The matrix is symmetric: its lower triangle is kept.
template <std::size_t N>
struct NormalEquations {
  std::array<std::array<double, N>, N> a{};
  std::array<double, N> b{};
};

// Fits to points that come one by one. Keeps its memory from one patch to the next.
class PatchFit {
 public:
  // Heights are those over the frame of `surface`. Distances are measured in units of the length h;
  // `roughness`: by which points lie off the surface, as a length.
  void start(const LocalSurface& surface, double h, double roughness);
  void add(Vec3 p, double weight);

  // Weighted least squares: sets the coefficients of the surface. O(1).
  void fit(Form form, LocalSurface& surface) const;

  // A plane if most members lie on one, else a quadric; iteratively reweighted with Tukey's
  // bisquare, its scale the median residual, from the least squares fit on. O(members).
  void fit_robustly(LocalSurface& surface);

 private:
  using Coefficients = std::array<double, 6>;  // of a height field in units of h

  // From the least squares fit on. Returns, of a plane, whether most members lie on it exactly.
  template <std::size_t N>
  bool run();
  template <std::size_t N>
  void measure();
  template <std::size_t N>
  void refit(double width);
  double median_residual() const;
  bool is_plane();

  LocalSurface frame_;
  double h_ = 1, roughness_ = 0;           // the latter in units of h
  std::vector<double> x_, y_, z_;          // per member: its place in the frame, in units of h
  std::vector<double> weight_, residual_;  // per member
  NormalEquations<6> sums_;                // of all members
  Coefficients c_{};
};

}  // namespace arris
