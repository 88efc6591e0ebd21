// What a reconstruction did: counts, energies, times, confidence, certificate.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "arris/check.h"
#include "arris/features.h"
#include "arris/options.h"
#include "arris/types.h"

namespace arris {

struct StageReport {
  std::string name;               // "delaunay", "seeds", "cut", ...
  double seconds = 0;             // wall clock
  std::uint64_t peak_memory = 0;  // bytes resident at most, of the process, up to its end
};

// What is in a FeatureNetwork.
struct FeatureCounts {
  std::uint64_t curves = 0, closed_curves = 0, convex_curves = 0, concave_curves = 0;
  std::uint64_t corners = 0;  // where two or more curves meet
  std::uint64_t ends = 0;     // where one fades out
  std::uint64_t patches = 0;
  double length = 0;  // of all curves, user's unit
};
FeatureCounts count_features(const FeatureNetwork& network);

struct Report {
  Options options;  // as used: defaults of the method filled in
  unsigned threads = 0;

  std::uint64_t input_points = 0, non_finite_points = 0, duplicate_points = 0;
  std::uint64_t stray_outliers = 0;    // removed by their company: strays and clumps
  std::uint64_t surface_outliers = 0;  // removed by the first surface: spikes and islands
  std::uint64_t samples = 0;           // distinct finite points that were not removed
  std::uint64_t background_points = 0;
  std::uint64_t tetrahedra = 0;       // finite
  std::uint64_t free_tetrahedra = 0;  // decided by the cut, not by seeds
  std::uint64_t feature_points = 0;   // added on edges and corners that no sample lies on
  std::uint64_t refine_points = 0;    // added on curved surface, in gaps or everywhere
  std::uint64_t surface_samples = 0;  // samples that are vertices of the mesh
  Vec3 shift;                         // local frame = (user - shift) * scale, exactly
  double scale = 1;
  double spacing = 0;  // median sample spacing, user's unit

  // Share of the evidence for inside/outside that contradicts the labels used, in [0, 1]; 0 is a
  // clean cloud. Per sample in Reconstruction::confidence.
  double contradiction = 0;

  std::vector<double> cut_energy;    // E after each cut, lengths in units of spacing (eq. 6)
  std::vector<double> swap_energy;   // E before the first and after each round of swaps (eq. 9)
  std::uint64_t swaps = 0;           // accepted
  std::uint64_t manifold_flips = 0;  // tetrahedra relabelled to make the surface a 2-manifold

  // The noise stage: standard deviation of the noise along the surface normal (user's unit), its
  // median and its highest over the samples, and how many samples were moved.
  double noise_median = 0, noise_highest = 0;
  std::uint64_t moved_samples = 0;

  std::uint64_t specks = 0;  // parts and voids too small to be meant, removed

  std::uint64_t filled_faces = 0;  // that no sample supports: Reconstruction::filled
  double filled_area = 0;          // their share of the area of the closed mesh, in [0, 1]
  bool trimmed = false;            // the mesh is open: the filled faces were taken away
  FeatureCounts features;

  std::vector<StageReport> stages;
  Certificate certificate;
  std::vector<std::string> warnings;
};

// The report as JSON (UTF-8, two-space indent, keys in a fixed order). Times and memory differ
// between runs; everything else is deterministic.
std::string to_json(const Report& report);

}  // namespace arris
