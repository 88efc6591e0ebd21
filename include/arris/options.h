// What to compute. Every number is dimensionless: lengths are in units of the local sample spacing.
#pragma once

#include <cstdint>

namespace arris {

// `automatic`: Delaunay of the samples and of points on features that no sample marks, a cut for
// each, swaps with polyhedral curvature.
// `paper`: the setting of Shi, Wan, Tai, Wang (SSVM 2011): background points, three cuts with the
// curvature of the last surface, swaps with cotangent curvature.
enum class Method : std::uint8_t { automatic, paper };

// What λ weighs. Curvature, which the swap stage measures by eq. 7-10 of the paper (cotangent) or
// as length x |pi - dihedral| / 2 (polyhedral); or, to compare with, `area`: the total variation of
// the indicator function of the solid, E = ∫ (d + λ) ds with λ in units of spacing, in cut and
// swaps.
enum class Curvature : std::uint8_t { by_method, cotangent, polyhedral, area };

// What to do with points whose coordinates are NaN or infinite.
enum class NonFinite : std::uint8_t { refuse, drop };

// What to do with points that belong to no surface: strays, clumps, spikes. `by_method` drops them,
// but for the paper's method, which uses every point.
enum class Outliers : std::uint8_t { by_method, drop, keep };

struct Options {
  Method method = Method::automatic;

  // Weight of curvature against distance in eq. 3, in units of spacing squared. >= 0.
  double lambda = 0.1;

  // Cuts in the loop of eq. 6; 0 means the default of the method, or 1 with `area`, where all cuts
  // are the same. 1 to 100.
  int cycles = 0;

  // Background points per sample (paper, section 3); negative means the default of the method
  // (0 for automatic, 10 for paper). At most 1000.
  double background = -1;

  Curvature curvature = Curvature::by_method;

  // Run the local swaps of section 4.
  bool swap = true;

  // Refuse swaps that take a sample off the surface. Without this every energy cuts edges off,
  // area nearly all of them: the comparison of the paper's figure 6.
  bool keep_samples = true;

  // Add points on edges and corners that no sample lies on, and on curved surface in the gaps that
  // random samples leave. Off in the paper's method.
  bool sharpen = true;

  // Add points on the smooth surface between all samples where it is curved. Off with the paper's
  // method.
  bool refine = false;

  // Also return the interior tetrahedra.
  bool tetrahedra = false;

  // Return the open mesh without the filled faces (Reconstruction::filled).
  bool trim = false;

  NonFinite non_finite = NonFinite::refuse;

  Outliers outliers = Outliers::by_method;

  // Standard deviation of the measurement noise along the surface normal, in the user's unit:
  // samples are moved by up to about three of it onto the surface that they agree on. 0: samples
  // stay where they are. Negative: the default of the method (estimated from the samples, place by
  // place, for automatic; 0 for paper).
  double noise = -1;
};

}  // namespace arris
