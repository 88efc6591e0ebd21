// What the reconstructions of the guard reach, recorded. To record anew after a change for the
// better, run
//   ARRIS_PRINT_FIGURES=1 build/test_quality --gtest_brief=1
// and put the rows it prints in place of these; say in the commit what got better and what worse.
#pragma once

namespace arris::test {

enum class Sampling { feature, blue, uniform, noise, outliers };
enum class Topology { wrong, right };

inline constexpr double no_edges = -1;

struct Figures {
  double chamfer;         // 1e-4 of the truth's diagonal
  double edge_f1;         // strict: at 0.1 % of the diagonal, 30 degrees; or no_edges of the truth
  double normal_error;    // degrees, of the result
  double volume_deficit;  // 1 - IoU
  Topology topology;      // components, Euler characteristic and genus as the truth
};

struct QualityCase {
  const char* shape;  // of tests/support/shapes.h
  Sampling sampling;
  unsigned samples;
  Figures recorded;
};

// Reconstructions are deterministic, so a figure moves only if the code does. Some freedom is left
// to changes that trade little for little; what a user would see on a picture is more than this.
namespace freedom {
inline constexpr double chamfer_part = 0.15, chamfer = 0.02;  // of the figure, and 1e-4 diagonals
inline constexpr double edge_f1 = 0.04;
inline constexpr double normal_part = 0.15, normal = 0.15;  // of the figure, and degrees
inline constexpr double volume_part = 0.15, volume = 2e-4;
// A right topology must stay right.
}  // namespace freedom

// Polyhedra with sampled edges come back exactly or nearly so; any loss there is a fault. `blue`
// and `uniform` leave edges unsampled: they guard the bevels and, on narrow parts (thin_plate,
// tangled_frames), the topology. Curved shapes guard the normals. noise: 0.25 % of the diagonal;
// outliers: 2 %.
inline constexpr QualityCase quality_cases[] = {
    {"cube", Sampling::feature, 3000, {0.000, 1.000, 0.00, 0.00000, Topology::right}},
    {"perforated_cube", Sampling::feature, 4000, {0.030, 0.992, 0.04, 0.00009, Topology::right}},
    {"tangled_frames", Sampling::feature, 6000, {0.000, 1.000, 0.00, 0.00000, Topology::right}},
    {"dodecahedron", Sampling::feature, 3000, {0.000, 1.000, 0.00, 0.00000, Topology::right}},
    {"wedge", Sampling::feature, 3000, {0.170, 0.893, 0.17, 0.00033, Topology::right}},
    {"thin_plate", Sampling::feature, 4000, {0.000, 1.000, 0.00, 0.00000, Topology::right}},
    {"cylinder", Sampling::feature, 3000, {0.589, 1.000, 0.89, 0.00086, Topology::right}},
    {"cone", Sampling::feature, 3000, {0.768, 0.925, 1.03, 0.00130, Topology::right}},
    {"cube", Sampling::blue, 3000, {1.014, 0.116, 1.82, 0.00167, Topology::right}},
    {"l_bracket", Sampling::blue, 4000, {1.032, 0.150, 2.05, 0.00236, Topology::right}},
    {"perforated_cube", Sampling::blue, 6000, {1.587, 0.133, 3.44, 0.00478, Topology::right}},
    {"tangled_frames", Sampling::blue, 8000, {2.540, 0.136, 5.67, 0.01586, Topology::right}},
    {"thin_plate", Sampling::blue, 6000, {0.574, 0.211, 1.57, 0.00453, Topology::right}},
    {"nested_shells", Sampling::blue, 6000, {1.000, 0.163, 1.99, 0.00290, Topology::right}},
    {"dodecahedron", Sampling::blue, 3000, {1.225, 0.138, 1.80, 0.00153, Topology::right}},
    {"steps", Sampling::blue, 4000, {1.181, 0.134, 2.27, 0.00239, Topology::right}},
    {"cylinder", Sampling::blue, 4000, {0.967, 0.092, 1.64, 0.00135, Topology::right}},
    {"torus", Sampling::blue, 4000, {2.079, -1.000, 2.86, 0.00445, Topology::right}},
    {"sphere", Sampling::blue, 3000, {2.290, -1.000, 1.80, 0.00237, Topology::right}},
    {"cube", Sampling::uniform, 4000, {1.638, 0.083, 2.30, 0.00265, Topology::right}},
    {"perforated_cube", Sampling::uniform, 8000, {2.453, 0.116, 4.35, 0.00730, Topology::right}},
    {"l_bracket", Sampling::uniform, 6000, {1.374, 0.141, 2.41, 0.00309, Topology::right}},
    {"torus", Sampling::uniform, 6000, {2.976, -1.000, 3.61, 0.00630, Topology::right}},
    {"cube", Sampling::noise, 4000, {14.947, 0.007, 19.49, 0.02603, Topology::right}},
    {"l_bracket", Sampling::noise, 5000, {14.810, 0.011, 21.61, 0.03554, Topology::right}},
    {"cylinder", Sampling::noise, 4000, {14.701, 0.006, 17.82, 0.02131, Topology::right}},
    {"torus", Sampling::noise, 5000, {14.418, -1.000, 18.08, 0.03075, Topology::right}},
    {"cube", Sampling::outliers, 4000, {615.514, 0.045, 34.43, 0.99973, Topology::right}},
    {"l_bracket", Sampling::outliers, 5000, {401.127, 0.092, 28.61, 0.26227, Topology::right}},
    {"torus", Sampling::outliers, 5000, {1.769, -1.000, 2.78, 0.00377, Topology::right}},
};

}  // namespace arris::test
