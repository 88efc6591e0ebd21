// Which faces are filled, and that what is left without them has a clean boundary.
#include "surface/fills.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "arris/check.h"
#include "base/vec.h"
#include "support/job.h"
#include "support/random.h"
#include "surface/shapes.h"

namespace arris {
namespace {

using test::OneStageJob;
using test::Random;

constexpr Index around = 40;  // the torus has 2 * 40 * 40 triangles

std::vector<std::uint8_t> fills_of(const Mesh& mesh, const FaceGaps& gaps) {
  OneStageJob job;
  const MeshTopology topology = build_topology(mesh.vertices.size(), mesh.triangles, job);
  return filled_faces(mesh.vertices, mesh.triangles, topology, gaps);
}

// Every face spans this gap at a spacing of about an edge length.
FaceGaps even_gaps(const Mesh& mesh, float gap) {
  return {std::vector<float>(mesh.triangles.size(), gap),
          std::vector<double>(mesh.triangles.size(), 0.3)};
}

Vec3 centre(const Mesh& mesh, std::size_t t) {
  const Triangle& c = mesh.triangles[t];
  return 1.0 / 3 * (mesh.vertices[c[0]] + mesh.vertices[c[1]] + mesh.vertices[c[2]]);
}

// Sets the gap of the faces within `radius` of `middle`.
void set_gap(const Mesh& mesh, Vec3 middle, double radius, float gap, FaceGaps& gaps) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (distance(centre(mesh, t), middle) < radius) gaps.gap[t] = gap;
}

std::ptrdiff_t count_filled(const std::vector<std::uint8_t>& filled) {
  return std::count(filled.begin(), filled.end(), 1);
}

// The faces near `middle` are filled, and beyond them none but some that touch them: those that
// made the boundary unclean.
void expect_region(const Mesh& mesh, const std::vector<std::uint8_t>& filled, Vec3 middle,
                   double radius) {
  std::vector<std::uint8_t> touched(mesh.vertices.size(), 0);
  const auto inside = [&](std::size_t t) { return distance(centre(mesh, t), middle) < radius; };
  std::size_t region = 0, beyond = 0;
  for (std::size_t t = 0; t < filled.size(); ++t) {
    if (!inside(t)) continue;
    ++region;
    EXPECT_EQ(filled[t], 1) << t;
    for (Index v : mesh.triangles[t]) touched[v] = 1;
  }
  for (std::size_t t = 0; t < filled.size(); ++t) {
    if (inside(t) || !filled[t]) continue;
    ++beyond;
    const Triangle& c = mesh.triangles[t];
    EXPECT_TRUE(touched[c[0]] || touched[c[1]] || touched[c[2]]) << t;
  }
  EXPECT_GT(region, 0u);
  EXPECT_LT(beyond, region / 5);
}

TEST(Fills, ThereAreNoneWhereSamplesAreDense) {
  const Mesh mesh = shapes::torus(around);
  EXPECT_EQ(count_filled(fills_of(mesh, even_gaps(mesh, 0.9f))), 0);
  EXPECT_EQ(count_filled(fills_of(mesh, even_gaps(mesh, 1.9f))), 0);  // random samples do that
}

TEST(Fills, GrowFromSureFacesOverLikelyOnes) {
  const Mesh mesh = shapes::torus(around);
  FaceGaps gaps = even_gaps(mesh, 0.9f);
  set_gap(mesh, {3, 0, 0}, 1.2, 1.5f, gaps);
  EXPECT_EQ(count_filled(fills_of(mesh, gaps)), 0);
  set_gap(mesh, {3, 0, 0}, 0.4, 3, gaps);
  expect_region(mesh, fills_of(mesh, gaps), {3, 0, 0}, 1.2);
}

TEST(Fills, SpecksAndIslandsDoNotCount) {
  const Mesh mesh = shapes::torus(around);
  FaceGaps gaps = even_gaps(mesh, 0.9f);
  gaps.gap[5] = 9;  // a speck
  EXPECT_EQ(count_filled(fills_of(mesh, gaps)), 0);
  set_gap(mesh, {3, 0, 0}, 1.5, 3, gaps);
  set_gap(mesh, {3, 0, 0}, 0.3, 0.9f, gaps);  // an island in a hole
  expect_region(mesh, fills_of(mesh, gaps), {3, 0, 0}, 1.5);
}

TEST(Fills, ASmallComponentOfItsOwnIsNoIsland) {
  const Mesh mesh = shapes::joined(shapes::torus(around), shapes::cube({9, 9, 9}, 0.1));
  FaceGaps gaps = even_gaps(mesh, 0.9f);
  EXPECT_EQ(count_filled(fills_of(mesh, gaps)), 0);
}

// A 2-manifold with boundary, or nothing at all.
void expect_clean_boundary(const Mesh& mesh, const std::vector<std::uint8_t>& filled) {
  const Mesh part = extract_part(mesh, kept_elements(mesh, filled));
  if (part.triangles.empty()) return;
  const auto certificate = check(part);
  RC_ASSERT(static_cast<bool>(certificate));
  RC_ASSERT(certificate->sound());
  RC_ASSERT(certificate->closed() == (part.triangles.size() == mesh.triangles.size()));
  RC_ASSERT(certificate->unreferenced_vertices == 0u);
}

RC_GTEST_PROP(FillsProperty, WhatIsLeftHasACleanBoundary, ()) {
  const Mesh mesh = shapes::torus(around);
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const double share = *rc::gen::element(0.02, 0.2, 0.5, 0.8, 0.99);
  FaceGaps gaps = even_gaps(mesh, 0.5f);
  for (float& gap : gaps.gap)
    if (random.unit() < share) gap = static_cast<float>(1 + 2 * random.unit());
  expect_clean_boundary(mesh, fills_of(mesh, gaps));
}

RC_GTEST_PROP(FillsProperty, PartAndRestAreTheWhole, ()) {
  Mesh mesh = shapes::torus(around);
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  mesh.attributes = {{"number", ScalarType::f64, {}}};
  mesh.face_attributes = {{"number", ScalarType::f64, {}}};
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    mesh.source.push_back(static_cast<Index>(v));
    mesh.attributes[0].values.push_back(static_cast<double>(v));
  }
  std::vector<std::uint8_t> dropped, kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    mesh.face_attributes[0].values.push_back(static_cast<double>(t));
    dropped.push_back(random.unit() < 0.5);
    kept.push_back(dropped.back() ^ 1);
  }
  std::vector<std::uint8_t> seen(mesh.triangles.size(), 0);
  for (const auto& flags : {dropped, kept}) {
    const Mesh part = extract_part(mesh, kept_elements(mesh, flags));
    for (std::size_t t = 0; t < part.triangles.size(); ++t) {
      const auto whole = static_cast<std::size_t>(part.face_attributes[0].values[t]);
      RC_ASSERT(++seen[whole] == 1);
      for (std::size_t k = 0; k < 3; ++k) {
        const Index v = part.triangles[t][k];
        RC_ASSERT(part.source[v] == mesh.triangles[whole][k]);
        RC_ASSERT(part.vertices[v] == mesh.vertices[part.source[v]]);
        RC_ASSERT(part.attributes[0].values[v] == static_cast<double>(part.source[v]));
      }
    }
  }
  RC_ASSERT(std::count(seen.begin(), seen.end(), 1) ==
            static_cast<std::ptrdiff_t>(mesh.triangles.size()));
}

}  // namespace
}  // namespace arris
