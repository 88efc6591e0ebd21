// What the reconstructions of the guard reach, recorded. To record anew after a change for the
// better, run
//   ARRIS_PRINT_FIGURES=1 build/test_quality --gtest_brief=1
// and put the rows it prints in place of these; say in the commit what got better and what worse.
#pragma once

namespace arris::test {

enum class Sampling { feature, blue, refined, uniform, noise, outliers };
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
// and `uniform` leave edges unsampled: they guard the points put on them and, on narrow parts
// (thin_plate, tangled_frames), the topology. Curved shapes guard the normals. noise: 0.25 % of the
// diagonal; outliers: 2 %; refined: blue, with Options::refine.
inline constexpr QualityCase quality_cases[] = {
    {"cube", Sampling::feature, 3000, {0.000, 1.000, 0.00, 0.00000, Topology::right}},
    {"perforated_cube", Sampling::feature, 4000, {0.000, 1.000, 0.00, 0.00000, Topology::right}},
    {"tangled_frames", Sampling::feature, 6000, {0.000, 1.000, 0.00, 0.00000, Topology::right}},
    {"dodecahedron", Sampling::feature, 3000, {0.000, 1.000, 0.00, 0.00000, Topology::right}},
    {"wedge", Sampling::feature, 3000, {0.000, 0.984, 0.00, 0.00000, Topology::right}},
    {"thin_plate", Sampling::feature, 4000, {0.000, 1.000, 0.00, 0.00000, Topology::right}},
    {"cylinder", Sampling::feature, 3000, {0.589, 1.000, 0.89, 0.00086, Topology::right}},
    {"cone", Sampling::feature, 3000, {0.732, 0.951, 1.00, 0.00122, Topology::right}},
    {"cube", Sampling::blue, 3000, {0.000, 0.980, 0.00, 0.00000, Topology::right}},
    {"l_bracket", Sampling::blue, 4000, {0.000, 0.992, 0.00, 0.00000, Topology::right}},
    {"perforated_cube", Sampling::blue, 6000, {0.001, 0.981, 0.00, 0.00000, Topology::right}},
    {"tangled_frames", Sampling::blue, 8000, {0.001, 0.990, 0.00, 0.00001, Topology::right}},
    {"thin_plate", Sampling::blue, 6000, {0.000, 0.992, 0.00, 0.00000, Topology::right}},
    {"nested_shells", Sampling::blue, 6000, {0.000, 0.987, 0.00, 0.00000, Topology::right}},
    {"dodecahedron", Sampling::blue, 3000, {0.000, 0.963, 0.00, 0.00000, Topology::right}},
    {"steps", Sampling::blue, 4000, {0.000, 0.982, 0.00, 0.00000, Topology::right}},
    {"cylinder", Sampling::blue, 4000, {0.429, 0.949, 0.75, 0.00061, Topology::right}},
    {"torus", Sampling::blue, 4000, {2.079, -1.000, 2.86, 0.00445, Topology::right}},
    {"sphere", Sampling::blue, 3000, {2.290, -1.000, 1.80, 0.00237, Topology::right}},
    {"cylinder", Sampling::refined, 4000, {0.188, 0.984, 0.60, 0.00027, Topology::right}},
    {"torus", Sampling::refined, 4000, {0.367, -1.000, 1.60, 0.00077, Topology::right}},
    {"cube", Sampling::uniform, 4000, {0.000, 0.976, 0.00, 0.00000, Topology::right}},
    {"perforated_cube", Sampling::uniform, 8000, {0.000, 0.981, 0.00, 0.00000, Topology::right}},
    {"l_bracket", Sampling::uniform, 6000, {0.000, 0.974, 0.00, 0.00000, Topology::right}},
    {"torus", Sampling::uniform, 6000, {1.680, -1.000, 2.66, 0.00354, Topology::right}},
    {"cube", Sampling::noise, 4000, {1.973, 0.985, 0.46, 0.00340, Topology::right}},
    {"l_bracket", Sampling::noise, 5000, {1.985, 0.976, 0.51, 0.00473, Topology::right}},
    {"cylinder", Sampling::noise, 4000, {2.363, 0.770, 1.06, 0.00341, Topology::right}},
    {"torus", Sampling::noise, 5000, {4.546, -1.000, 3.12, 0.00959, Topology::right}},
    {"cube", Sampling::outliers, 4000, {0.000, 0.989, 0.00, 0.00000, Topology::right}},
    {"l_bracket", Sampling::outliers, 5000, {0.000, 0.980, 0.00, 0.00000, Topology::right}},
    {"torus", Sampling::outliers, 5000, {1.668, -1.000, 2.68, 0.00355, Topology::right}},
};

}  // namespace arris::test
