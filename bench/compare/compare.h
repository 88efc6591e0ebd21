// How good a mesh is, held against the truth. Every definition, with its source, is in
// docs/metrics.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "arris/check.h"
#include "arris/context.h"
#include "arris/error.h"
#include "arris/types.h"

namespace arris::compare {

// Every length in a Comparison is a fraction of the diagonal of the truth's bounding box, every
// angle in degrees. A figure that has no meaning for a pair of meshes is NaN (null in JSON).
inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

// What still counts as found: 0.5 % and 0.1 % of the diagonal.
inline constexpr double loose_tolerance = 0.005, strict_tolerance = 0.001;

// Dihedral thresholds of Comparison::sweep.
inline constexpr double sweep_angles[] = {15, 30, 60, 90};

struct CompareOptions {
  std::size_t samples = 100000;  // on each surface, and columns for the volume; 1000 to 10^8
  double dihedral = 30;          // an edge is sharp if the surface turns by so much, 0 to 180
  std::uint64_t seed = 1;
  bool ndc = true;  // also the edge metric of NDC: half a second, whatever the meshes
};

// Precision: share of the result that is right. Recall: share of the truth that was found.
struct Score {
  double precision = undefined, recall = undefined, f1 = undefined;
};

// From samples of one surface to the other surface.
struct Directed {
  double mean = 0, rms = 0, p99 = 0;
  double max = 0;                              // over the samples and all vertices
  double within_loose = 0, within_strict = 0;  // shares of the samples
  double normal_error = 0;           // mean angle between normals, orientation ignored, 0 to 90
  double normal_error_oriented = 0;  // the same with orientation, 0 to 180
  double normal_bad = 0;             // share of samples with normal_error above 15 degrees
};

// Sharp edges and corners at one dihedral threshold.
struct FeatureScore {
  double dihedral = 0;
  Score loose, strict;
  double chamfer = undefined;  // mean distance between edges, of both directions
  double length_result = 0, length_truth = 0;
  Score corners;  // at the loose tolerance
  std::size_t corners_result = 0, corners_truth = 0;
};

// The edge metric of Neural Dual Contouring, on points drawn on the surfaces.
struct NdcScore {
  Score edge;                  // at 0.005; edge.f1 is EF1
  double chamfer = undefined;  // ECD: sum of both mean squared distances
  std::size_t points_result = 0, points_truth = 0;
};

// What one of the meshes is, by itself.
struct MeshFacts {
  Certificate certificate;             // counts of defects, components, Euler characteristic
  std::uint64_t odd_edges = 0;         // an odd number of triangles: the mesh has no inside
  std::uint64_t unbalanced_edges = 0;  // an even number, not half of which walk it either way
  std::optional<std::int64_t> genus;   // sum over components; only of closed oriented manifolds
};

struct Comparison {
  double diagonal = 0;  // of the truth's bounding box, user's unit
  std::size_t samples = 0;
  Directed result_to_truth, truth_to_result;
  double chamfer = 0, hausdorff = 0, rms = 0;
  Score loose, strict;  // of the surfaces: the F-score at both tolerances
  FeatureScore features;
  std::vector<FeatureScore> sweep;  // at sweep_angles
  NdcScore ndc;
  double volume_iou = undefined;
  MeshFacts result, truth;
  bool same_topology = false;      // components, Euler characteristic and genus agree
  std::vector<std::string> notes;  // why figures are undefined, or to be read with care
};

// Compares two triangle soups, neither of which is repaired. The same for any number of threads.
// Errors: usage, bad_points, unreadable, degenerate (see surface.h), out_of_memory, cancelled.
// Complexity: O((n + samples) log n) for n triangles.
Result<Comparison> compare_meshes(const Mesh& result, const Mesh& truth,
                                  const CompareOptions& options = {}, const Context& context = {});

// UTF-8, two-space indent, keys in a fixed order.
std::string to_json(const Comparison& comparison);

}  // namespace arris::compare
