// A polynomial height field of third order over a tangent frame: what a smooth surface does near
// one place, to an order higher than its curvature ("jet": Cazals and Pouget, "Estimating
// differential quantities using polynomial fitting of osculating jets", 2003).
#pragma once

#include <array>
#include <vector>

#include "arris/types.h"

namespace arris {

// z = sum of c_k times the monomials 1, x, y, x², xy, y², x³, x²y, xy², y³ in the frame (u, v, n)
// at `origin`; x, y and z in units of `unit`.
struct Jet {
  Vec3 origin;
  Vec3 u, v, n;  // orthonormal
  double unit = 1;
  std::array<double, 10> c{};
  double residual = 0;  // root mean square per degree of freedom, a length

  // Of the surface over the foot of p, a length.
  double height(Vec3 p) const noexcept;
  // Unit normal over the origin, on the side of n.
  Vec3 normal() const noexcept;
};

// Least squares, weighted by a Gaussian of the distance from the origin. `unit`: about the
// distance between neighbours. Terms that the points do not determine stay near 0; more than ten
// members say how well they fit. O(members).
Jet fit_jet(const std::vector<Vec3>& points, const std::vector<Index>& members, Vec3 origin, Vec3 n,
            double unit);

}  // namespace arris
