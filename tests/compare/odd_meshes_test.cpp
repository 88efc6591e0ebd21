// Meshes that are open, crossed, degenerate or no meshes at all.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "base/vec.h"
#include "compare/compare.h"
#include "compare/error_map.h"
#include "support/shapes.h"

namespace arris::test {
namespace {

using compare::Comparison;

Comparison comparison_of(const Mesh& result, const Mesh& truth, bool ndc = false) {
  compare::CompareOptions options;
  options.samples = 5000;
  options.ndc = ndc;
  const auto comparison = compare::compare_meshes(result, truth, options);
  EXPECT_TRUE(comparison) << comparison.error().message;
  return comparison ? *comparison : Comparison{};
}

bool notes(const Comparison& c, const std::string& text) {
  for (const std::string& note : c.notes)
    if (note.find(text) != std::string::npos) return true;
  return false;
}

void append(Mesh& mesh, const Mesh& other) {
  const auto first = static_cast<Index>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

TEST(OddMeshes, AnOpenResultHasNoVolumeAndNoGenus) {
  Mesh open = cube().mesh;
  open.triangles.pop_back();
  const Comparison c = comparison_of(open, cube().mesh);
  EXPECT_TRUE(std::isnan(c.volume_iou));
  EXPECT_FALSE(c.result.genus);
  EXPECT_FALSE(c.same_topology);
  EXPECT_EQ(c.result.odd_edges, 3u);
  EXPECT_TRUE(notes(c, "the result has 3 edge(s) with an odd number of triangles")) << to_json(c);
  EXPECT_EQ(c.strict.precision, 1);
  EXPECT_LT(c.strict.recall, 1);
  EXPECT_NE(to_json(c).find("\"volume_iou\": null"), std::string::npos);
}

// Four triangles at one edge: still an inside, but no genus.
TEST(OddMeshes, NonManifoldEdgesKeepTheirVolume) {
  Mesh touching = box_complex({{{0, 0, 0}, {1, 1, 1}}});
  const Mesh other = box_complex({{{1, 1, 0}, {2, 2, 1}}});
  append(touching, other);
  for (Triangle& t : touching.triangles)
    for (Index& v : t)
      for (Index u = 0; u < v; ++u)
        if (touching.vertices[u] == touching.vertices[v]) v = u;
  const Comparison c = comparison_of(touching, cube().mesh);
  EXPECT_EQ(c.result.certificate.nonmanifold_edges, 1u);
  EXPECT_FALSE(c.result.genus);
  EXPECT_NEAR(c.volume_iou, 0.5, 0.02);
}

// Overlapping parts of a surface that crosses itself are inside by their winding number.
TEST(OddMeshes, CrossedPartsAreInsideByWinding) {
  Mesh crossed = box_complex({{{0, 0, 0}, {2, 1, 1}}});
  append(crossed, box_complex({{{1, 0.25, 0.25}, {3, 0.75, 0.75}}}));
  const Mesh truth = box_complex({{{0, 0, 0}, {2, 1, 1}}, {{1, 0.25, 0.25}, {3, 0.75, 0.75}}});
  const Comparison c = comparison_of(crossed, truth);
  EXPECT_GT(c.result.certificate.intersecting_pairs, 0u);
  EXPECT_NEAR(c.volume_iou, 1, 1e-12);
  EXPECT_TRUE(notes(c, "of triangles that intersect"));
}

TEST(OddMeshes, DegenerateTrianglesAreLeftOut) {
  Mesh result = cube().mesh;
  result.triangles.push_back({0, 0, 1});
  result.vertices.push_back({0.5 * (result.vertices[0] + result.vertices[1])});
  result.triangles.push_back({0, 1, static_cast<Index>(result.vertices.size() - 1)});
  const Comparison c = comparison_of(result, cube().mesh);
  EXPECT_LT(c.hausdorff, 1e-14);
  EXPECT_EQ(c.result.certificate.degenerate_triangles, 2u);
  EXPECT_TRUE(notes(c, "2 degenerate triangle(s)"));
}

// Unused vertices are no part of a mesh, wherever they are.
TEST(OddMeshes, UnusedVerticesDoNotCount) {
  Mesh truth = cube().mesh;
  truth.vertices.push_back({std::numeric_limits<double>::quiet_NaN(), 100, 0});
  const Comparison c = comparison_of(cube().mesh, truth);
  EXPECT_EQ(c.diagonal, std::sqrt(3.0));
  EXPECT_LT(c.hausdorff, 1e-14);
}

TEST(OddMeshes, ASmoothTruthHasNoRecallOfEdges) {
  const Comparison c = comparison_of(cube().mesh, sphere().mesh, true);
  EXPECT_TRUE(std::isnan(c.features.loose.recall));
  EXPECT_EQ(c.features.loose.precision, 0);
  EXPECT_EQ(c.features.loose.f1, 0);
  EXPECT_EQ(c.ndc.edge.f1, 1);  // as the published evaluation has it
  EXPECT_TRUE(notes(c, "the truth has no sharp edges"));
}

struct Refusal {
  const char* name;
  std::function<void(Mesh&)> spoil;
  ErrorCode code;
};

const Refusal refusals[] = {
    {"NoTriangles", [](Mesh& m) { m.triangles.clear(); }, ErrorCode::bad_points},
    {"NotFinite", [](Mesh& m) { m.vertices[1].y = std::numeric_limits<double>::infinity(); },
     ErrorCode::bad_points},
    {"BeyondMeasure", [](Mesh& m) { m.vertices[1].y = 1e200; }, ErrorCode::bad_points},
    {"BadIndex", [](Mesh& m) { m.triangles[2][1] = 99; }, ErrorCode::unreadable},
    {"NoArea",
     [](Mesh& m) {
       for (Vec3& p : m.vertices) p.y = p.z = 0;
     },
     ErrorCode::degenerate},
    {"OnePoint",
     [](Mesh& m) {
       for (Vec3& p : m.vertices) p = {1, 2, 3};
     },
     ErrorCode::degenerate},
};

TEST(OddMeshes, AreRefusedByName) {
  for (const Refusal& refusal : refusals) {
    SCOPED_TRACE(refusal.name);
    Mesh bad = cube().mesh;
    refusal.spoil(bad);
    const auto as_result = compare::compare_meshes(bad, cube().mesh);
    const auto as_truth = compare::compare_meshes(cube().mesh, bad);
    ASSERT_FALSE(as_result);
    ASSERT_FALSE(as_truth);
    EXPECT_EQ(as_result.error().code, refusal.code);
    EXPECT_EQ(as_truth.error().code, refusal.code);
    EXPECT_NE(as_result.error().message.find("result"), std::string::npos);
    EXPECT_NE(as_truth.error().message.find("truth"), std::string::npos);
    EXPECT_FALSE(compare::DistanceToMesh::make(bad, "truth"));
  }
}

TEST(OddMeshes, OptionsOutOfRangeAreRefused) {
  compare::CompareOptions few, flat;
  few.samples = 10;
  flat.dihedral = 0;
  for (const auto& options : {few, flat}) {
    const auto c = compare::compare_meshes(cube().mesh, cube().mesh, options);
    ASSERT_FALSE(c);
    EXPECT_EQ(c.error().code, ErrorCode::usage);
  }
}

TEST(OddMeshes, ComparisonStopsAndRefusesWhenAsked) {
  std::atomic<bool> stop = true;
  Context context;
  context.cancel = &stop;
  const auto cancelled = compare::compare_meshes(cube().mesh, cube().mesh, {}, context);
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().code, ErrorCode::cancelled);
  Context small;
  small.memory_limit = 1 << 20;
  const auto refused = compare::compare_meshes(cube().mesh, cube().mesh, {}, small);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::out_of_memory);
}

}  // namespace
}  // namespace arris::test
