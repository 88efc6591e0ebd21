// Least squares and robust fits of a LocalSurface to the members of a patch.
#pragma once

#include <vector>

#include "feature/local_surface.h"

namespace arris {

enum class Form : std::uint8_t { plane, quadric };

// Points with weights, and the length h in which distances are measured.
struct FitData {
  const std::vector<Vec3>& points;
  const std::vector<Index>& members;
  const std::vector<double>& weight;
  double h;
};

// Weighted least squares of the height over the frame of `surface`. O(members).
void fit(const FitData& data, Form form, LocalSurface& surface);

// A plane if most members lie on one, else a quadric; iteratively reweighted with Tukey's bisquare,
// its scale the median residual, from the least squares fit on.
void fit_robustly(const FitData& data, LocalSurface& surface);

}  // namespace arris
