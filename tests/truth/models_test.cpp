// The models by name: certified, with the topology and the measures that pencil and paper give.
#include "truth/models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>

#include "arris/check.h"
#include "base/vec.h"
#include "truth/feature_graph.h"
#include "truth/measure.h"
#include "truth/paper_models.h"
#include "truth/samplers.h"

namespace arris::truth {
namespace {

constexpr double pi = std::numbers::pi;

struct Row {
  const char* name;
  std::size_t components;
  long euler;
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.name;
}

const Row rows[] = {
    {"two_cubes", 1, 2},
    {"two_spheres", 1, 2},
    {"perforated_cube", 1, -8},
    {"tangled_cubes", 2, -16},
    {"male_symbol", 1, 0},
    {"female_symbol", 1, 0},
    {"dodecahedron", 1, 2},
    {"icosahedron", 1, 2},
    {"buckyball", 1, 2},
    {"brilliant_diamond", 1, 2},
    {"power_wheel", 1, 0},
    {"tear_drop", 1, 2},
    {"dumb_bell", 1, 2},
    {"bolt", 1, 2},
    {"cube", 1, 2},
    {"sphere", 1, 2},
    {"cylinder", 1, 2},
    {"cone", 1, 2},
    {"torus", 1, 0},
    {"thin_plate", 1, 2},
    {"wedge", 1, 2},
    {"l_bracket", 1, 2},
    {"drilled_bracket", 1, -6},
    {"nested_shells", 3, 6},
    {"steps", 1, 2},
    {"octahedron", 1, 2},
    {"hexagonal_prism", 1, 2},
};

class Models : public testing::TestWithParam<Row> {};

// Even, odd and the coarsest: the edges of parts meet differently in each.
TEST_P(Models, AreCertifiedAtEveryResolution) {
  for (const int resolution : {lowest_resolution, 57, 96}) {
    SCOPED_TRACE(resolution);
    const Mesh mesh = make_model(GetParam().name, resolution);
    const Result<Certificate> certificate = check(mesh);
    ASSERT_TRUE(certificate);
    EXPECT_TRUE(certificate->ok()) << certificate->first_defect;
    EXPECT_EQ(certificate->unreferenced_vertices, 0u);
    EXPECT_EQ(components(mesh), GetParam().components);
    EXPECT_EQ(euler(mesh), GetParam().euler);
  }
}

TEST_P(Models, AreCertifiedAtUnitDiagonal) {
  const Mesh mesh = to_unit_diagonal(make_model(GetParam().name, 48));
  const Bounds bounds = bounds_of(mesh.vertices);
  EXPECT_NEAR(bounds.diagonal(), 1, 1e-12);
  EXPECT_NEAR(length(bounds.centre()), 0, 1e-12);
  const Result<Certificate> certificate = check(mesh);
  ASSERT_TRUE(certificate);
  EXPECT_TRUE(certificate->ok()) << certificate->first_defect;
}

INSTANTIATE_TEST_SUITE_P(All, Models, testing::ValuesIn(rows),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(ModelNames, AreAllInTheTableAbove) {
  std::set<std::string> listed, tested;
  for (const ModelEntry& model : models()) listed.insert(model.name);
  for (const Row& row : rows) tested.insert(row.name);
  EXPECT_EQ(listed, tested);
  EXPECT_EQ(listed.size(), models().size());
}

TEST(ModelNames, UnknownOnesAndBadResolutionsAreRefused) {
  EXPECT_THROW(make_model("teapot"), std::out_of_range);
  EXPECT_THROW(make_model("sphere", lowest_resolution - 1), std::invalid_argument);
  EXPECT_THROW(make_model("sphere", highest_resolution + 1), std::invalid_argument);
}

// Volume of the part of a ball of radius r that is beyond a plane at distance d from its centre.
double cap(double r, double d) {
  return pi * (r - d) * (r - d) * (2 * r + d) / 3;
}

double ball(double r) {
  return 4 * pi / 3 * r * r * r;
}

TEST(PaperModels, TwoSpheresHaveTheVolumeOfTheirUnion) {
  const double meet = (1 - 0.85 * 0.85 + 1.15 * 1.15) / (2 * 1.15);
  const double expected = ball(1) + ball(0.85) - cap(1, meet) - cap(0.85, 1.15 - meet);
  EXPECT_NEAR(volume(two_spheres(192)) / expected, 1, 1e-3);
}

TEST(PaperModels, DumbBellIsTwoBallsAndABar) {
  const double half_chord = std::sqrt(0.25 - 0.16 * 0.16);
  const double bar = pi * 0.16 * 0.16 * (1.6 - 2 * half_chord);
  const double expected = 2 * (ball(0.5) - cap(0.5, half_chord)) + bar;
  EXPECT_NEAR(volume(dumb_bell(192)) / expected, 1, 1e-3);
}

TEST(PaperModels, BuckyballIsTheTruncatedIcosahedron) {
  const Mesh mesh = buckyball();
  EXPECT_EQ(mesh.vertices.size(), 60u);
  EXPECT_NEAR(volume(mesh), (125 + 43 * std::sqrt(5.0)) / 4 * 8, 1e-9);  // edge 2
  const FeatureGraph g = feature_graph(mesh, 0.1);
  EXPECT_EQ(g.sharp.size(), 90u);
  for (const SharpEdge& e : g.sharp)
    EXPECT_NEAR(distance(mesh.vertices[e.a], mesh.vertices[e.b]), 2, 1e-12);
}

// Euler: 57 corners, and 57 facets without culet but with 16 of the girdle.
TEST(PaperModels, BrilliantDiamondHasItsFacets) {
  const Mesh mesh = brilliant_diamond();
  EXPECT_EQ(mesh.vertices.size(), 57u);
  const std::size_t edges = feature_graph(mesh, 0.01).sharp.size();
  EXPECT_EQ(2 + edges - 57, 57u + 16u);
}

// The tip counts as a corner although no edge ends there; the rest is smooth.
TEST(PaperModels, TearDropIsSmoothButForItsTip) {
  const Mesh mesh = tear_drop(96);
  EXPECT_TRUE(feature_graph(mesh, pi / 6).sharp.empty());
  const std::vector<Vec3> features = feature_points(mesh, 0.01);
  ASSERT_EQ(features.size(), 1u);
  EXPECT_EQ(features[0], (Vec3{0, 0, 1}));
  // Of the piriform: integral of pi sin^2 t sin^2(t/2) sin t dt over [0, pi].
  EXPECT_NEAR(volume(tear_drop(192)), 2 * pi / 3, 2e-3);
}

TEST(PaperModels, DrilledBracketIsTwoPlatesLessFourHoles) {
  const double expected = 3 * 2 * 0.6 + 0.6 * 2 * 1.8 - 4 * pi * 0.28 * 0.28 * 0.6;
  EXPECT_NEAR(volume(drilled_bracket(192)) / expected, 1, 1e-3);
}

// Where parts were combined no slivers are left whose lost normals look like sharp edges: the
// curves in which round bars meet are loops without a corner, and nothing else is sharp.
TEST(PaperModels, FemaleSymbolHasRoundEdgesOnly) {
  const FeatureGraph g = feature_graph(female_symbol(192), pi / 6);
  EXPECT_FALSE(g.sharp.empty());
  EXPECT_EQ(std::count(g.corner.begin(), g.corner.end(), true), 0);
}

// One and a half turns show: between root and crest, and the crest climbs by the pitch.
TEST(ThreadedRod, IsAHelixBetweenItsRadii) {
  const Mesh rod = threaded_rod(0.4, 0.5, 0.2, 1, 48);
  const Result<Certificate> certificate = check(rod);
  ASSERT_TRUE(certificate && certificate->ok()) << certificate->first_defect;
  std::size_t crests = 0;
  for (const Vec3 p : rod.vertices) {
    const double r = std::hypot(p.x, p.y);
    if (std::abs(r - 0.5) > 1e-12) continue;
    ++crests;
    double turns = std::atan2(p.y, p.x) / (2 * pi);
    const double phase = p.z / 0.2 - turns - 0.5;  // a whole number on the crest
    EXPECT_NEAR(phase, std::round(phase), 1e-9);
  }
  EXPECT_GT(crests, 48u * 6u);
  EXPECT_LT(bounds_of(rod.vertices).low.z, 0);
  EXPECT_GT(bounds_of(rod.vertices).high.z, 1);
}

}  // namespace
}  // namespace arris::truth
