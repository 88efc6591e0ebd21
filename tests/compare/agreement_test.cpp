// Our figures against those of an evaluator written independently, on CGAL's trees and exact
// predicates. The figures below are its output of one run with a million samples of each kind on
// the files of make_pairs; the tests need neither it nor the files.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <stdexcept>
#include <string>

#include "compare/compare.h"
#include "compare/pairs.h"

namespace arris::test {
namespace {

using compare::Comparison;

constexpr double none = compare::undefined;
constexpr long no_genus = -1;

// What is counted on the meshes themselves, their edges and topology, needs no samples.
constexpr std::size_t many = 300000, fewest = 1000;

struct Figures {
  double chamfer, hausdorff, rms, fscore, fscore_strict;
  double normal_error, normal_error_back, normal_error_oriented;  // degrees
  double edge_precision, edge_recall, edge_precision_strict, edge_recall_strict, edge_chamfer;
  double edge_length_result, edge_length_truth, corner_precision, corner_recall, volume_iou;
};

struct Row {
  const char* pair;
  Figures figures;
  std::size_t components;
  long euler, genus;  // of the result
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.pair;
}

const Row rows[] = {
    {"shifted_cube",
     {0.00363872, 0.00695222, 0.00399973, 0.671, 0.00349288, 1.60407, 1.69857, 1.60407, 0.337327,
      0.337038, 0, 0, 0.00552865, 6.9282, 6.9282, 0, 0, 0.962931},
     1,
     2,
     0},
    {"bevelled_cube",
     {0.000243866, 0.0133333, 0.0011003, 0.980536, 0.942065, 2.52889, 3.54523, 2.52889, 0, 0, 0, 0,
      0.0114617, 13.6941, 6.9282, 0, 0, 0.997618},
     1,
     2,
     0},
    {"shaken_torus",
     {0.000550655, 0.00380982, 0.000693083, 1, 0.853531, 10.349, 10.3129, 10.349, 0, none, 0, none,
      none, 19.0235, 0, 0, none, 0.988969},
     1,
     0,
     1},
    {"ball_for_dodecahedron",
     {0.0534379, 0.0949696, 0.0551126, 0, 0, 22.336, 23.6175, 22.336, none, 0, none, 0, none, 0,
      6.61585, none, 0, 0.498874},
     1,
     2,
     0},
    {"moved_frames",
     {0.000603859, 0.00129161, 0.000742689, 1, 0.672114, 1.72836, 1.63494, 1.72836, 1, 1, 0.338398,
      0.337992, 0.00100722, 22.1809, 22.1809, 1, 1, 0.961459},
     2,
     -16,
     10},
    {"open_bracket",
     {0.0035962, 0.126031, 0.01273, 0.941882, 0.464509, 1.48995, 9.00828, 1.4908, 1, 0.752443,
      0.0601425, 0.0452117, 0.0186204, 5.75282, 7.67523, 1, 0.75, none},
     1,
     0,
     no_genus},
    {"inside_out_steps",
     {0.000853497, 0.0031909, 0.00127087, 1, 0.610126, 0.55719, 0.52245, 179.443, 1, 1, 0.249591,
      0.250821, 0.00171657, 8.56214, 8.52803, 1, 1, 0.98815},
     1,
     2,
     0},
    {"shell_without_core",
     {0.0181453, 0.23094, 0.0497616, 0.833334, 0.833334, 0, 0, 46.2852, 0.555609, 1, 0.555609, 1,
      0.0453522, 12.4708, 6.9282, 0.333333, 1, 0.792466},
     3,
     6,
     0},
};

void expect_figure(const char* what, double ours, double theirs, double tolerance) {
  if (std::isnan(theirs))
    EXPECT_TRUE(std::isnan(ours)) << what << " is " << ours;
  else
    EXPECT_NEAR(ours, theirs, tolerance) << what;
}

Comparison comparison_of(const Pair& pair, std::size_t samples) {
  compare::CompareOptions options;
  options.samples = samples;
  options.ndc = false;
  const auto comparison = compare::compare_meshes(pair.result, pair.truth, options);
  if (!comparison) throw std::runtime_error(comparison.error().message);
  return *comparison;
}

class Agreement : public testing::TestWithParam<Row> {
 protected:
  Comparison compare(std::size_t samples) const {
    for (const Pair& pair : comparison_pairs())
      if (pair.name == GetParam().pair) return comparison_of(pair, samples);
    throw std::runtime_error("there is no such pair");
  }
};

// Shares of 300,000 samples deviate by less than 0.001 (one standard deviation of the worst share),
// means by a hundredth. A normal error is compared with more slack, because faces that are equally
// near along an edge are a matter of taste: a share of a percent of the samples turns by 90
// degrees.
TEST_P(Agreement, WithinSamplingError) {
  const Figures& f = GetParam().figures;
  const Comparison c = compare(many);
  const auto& edges = c.features;
  constexpr double share = 0.003, part = 0.01, degrees = 0.25;
  expect_figure("chamfer", c.chamfer, f.chamfer, part * f.chamfer);
  expect_figure("rms", c.rms, f.rms, part * f.rms);
  // A maximum over samples is found the later the fewer there are.
  expect_figure("hausdorff", c.hausdorff, f.hausdorff, 2 * part * f.hausdorff);
  expect_figure("fscore", c.loose.f1, f.fscore, share);
  expect_figure("fscore_strict", c.strict.f1, f.fscore_strict, share);
  expect_figure("normal_error", c.result_to_truth.normal_error, f.normal_error, degrees);
  expect_figure("normal_error_back", c.truth_to_result.normal_error, f.normal_error_back, degrees);
  expect_figure("normal_error_oriented", c.result_to_truth.normal_error_oriented,
                f.normal_error_oriented, degrees);
  expect_figure("edge_precision", edges.loose.precision, f.edge_precision, share);
  expect_figure("edge_recall", edges.loose.recall, f.edge_recall, share);
  expect_figure("edge_precision_strict", edges.strict.precision, f.edge_precision_strict, share);
  expect_figure("edge_recall_strict", edges.strict.recall, f.edge_recall_strict, share);
  expect_figure("edge_chamfer", edges.chamfer, f.edge_chamfer, part * f.edge_chamfer);
  expect_figure("corner_precision", edges.corners.precision, f.corner_precision, 1e-5);
  expect_figure("corner_recall", edges.corners.recall, f.corner_recall, 1e-5);
  expect_figure("volume_iou", c.volume_iou, f.volume_iou, 0.0015);
}

// Our threshold has a slack of 0.01 degrees, theirs has none.
TEST_P(Agreement, LengthsOfSharpEdges) {
  const Figures& f = GetParam().figures;
  const auto edges = compare(fewest).features;
  expect_figure("result", edges.length_result, f.edge_length_result, 0.005 * f.edge_length_result);
  expect_figure("truth", edges.length_truth, f.edge_length_truth, 1e-5 * f.edge_length_truth);
}

TEST_P(Agreement, Topology) {
  const compare::MeshFacts result = compare(fewest).result;
  EXPECT_EQ(result.certificate.components, GetParam().components);
  EXPECT_EQ(result.certificate.euler, GetParam().euler);
  EXPECT_EQ(result.genus.value_or(no_genus), GetParam().genus);
}

INSTANTIATE_TEST_SUITE_P(Pairs, Agreement, testing::ValuesIn(rows),
                         [](const auto& test) { return std::string(test.param.pair); });

}  // namespace
}  // namespace arris::test
