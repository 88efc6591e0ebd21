#include "feature/sense.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/failure.h"
#include "feature/sensing.h"
#include "support/creases.h"
#include "support/measure.h"

namespace arris {
namespace {

using namespace test;

TEST(FacetMesh, KnowsWhatIsRoundAPointAndAcrossASide) {
  const Shape shape = octahedron();
  const FacetMesh mesh(shape.mesh.triangles, shape.mesh.vertices, 1);
  std::vector<Index> near;
  SmallSet seen;
  for (Index v = 0; v < 6; ++v) {
    EXPECT_EQ(mesh.star(v).size(), 4u);
    for (Index f : mesh.star(v))
      EXPECT_EQ(std::count(mesh.facets[f].begin(), mesh.facets[f].end(), v), 1);
    ring(mesh, v, near);
    EXPECT_EQ(near.size(), 4u);
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
    two_rings(mesh, v, seen, near);
    EXPECT_EQ(near.size(), 5u);  // the opposite one, too
  }
  for (Index f = 0; f < 8; ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const Triangle& other = mesh.facets[mesh.neighbours[f][i]];
      EXPECT_EQ(std::count(other.begin(), other.end(), mesh.facets[f][i]), 0);
      EXPECT_EQ(std::count(other.begin(), other.end(), mesh.facets[f][(i + 1) % 3]), 1);
      EXPECT_EQ(std::count(other.begin(), other.end(), mesh.facets[f][(i + 2) % 3]), 1);
    }
}

// A ring of n points, 0 .. n - 1, and two tips.
Mesh bipyramid(Index n) {
  Mesh mesh;
  for (Index k = 0; k < n; ++k) {
    const double a = radians(360.0 * k / n);
    mesh.vertices.push_back({std::cos(a), std::sin(a), 0});
    mesh.triangles.push_back({k, (k + 1) % n, n});
    mesh.triangles.push_back({(k + 1) % n, k, n + 1});
  }
  mesh.vertices.push_back({0, 0, 1});
  mesh.vertices.push_back({0, 0, -1});
  return mesh;
}

TEST(FacetMesh, OfAPointWithVeryManyFacetsThoseNearOneAreSeen) {
  constexpr Index n = 1000;
  const Mesh shape = bipyramid(n);
  const FacetMesh mesh(shape.triangles, shape.vertices, 1);
  std::vector<Index> buffer;
  SmallSet seen;
  for (const Index k : {0u, 500u, 990u}) {
    const auto near = mesh.star_near(n, 2 * k, buffer);  // facet 2k is over side k
    ASSERT_EQ(near.size(), most_round + 1);
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
    for (Index f : near) {
      EXPECT_EQ(f % 2, 0u);
      const Index apart = (f / 2 + n - k) % n;
      EXPECT_LE(std::min(apart, n - apart), most_round / 2);
    }
    EXPECT_EQ(mesh.star_near(k, 2 * k, buffer).size(), 4u);
    two_rings(mesh, k, seen, buffer);
    EXPECT_LE(buffer.size(), 2 * (most_round + 4));
    EXPECT_TRUE(std::binary_search(buffer.begin(), buffer.end(), (k + 1) % n));
    EXPECT_TRUE(std::binary_search(buffer.begin(), buffer.end(), n + 1));
  }
}

TEST(FacetMesh, KeepsTheNearestPoints) {
  const Mesh shape = bipyramid(100);
  std::vector<Index> list(100);
  for (Index k = 0; k < 100; ++k) list[k] = k;
  const std::vector<Index> all = list;
  keep_nearest(shape.vertices, 50, 100, list);
  EXPECT_EQ(list, all);
  keep_nearest(shape.vertices, 50, 5, list);
  EXPECT_EQ(list, (std::vector<Index>{48, 49, 50, 51, 52}));
}

TEST(FacetMesh, NeedlesHaveNoNormal) {
  Mesh mesh = octahedron().mesh;
  const FacetMesh round(mesh.triangles, mesh.vertices, 1);
  for (std::size_t f = 0; f < 8; ++f) EXPECT_NEAR(length(round.normal[f]), 1, 1e-15);
  for (Vec3& p : mesh.vertices) p.x *= 0.01;
  const FacetMesh flat(mesh.triangles, mesh.vertices, 1);
  for (std::size_t f = 0; f < 8; ++f) EXPECT_NEAR(length(flat.normal[f]), 1, 1e-15);  // still wide
  for (Vec3& p : mesh.vertices) p.y *= 0.01;
  const FacetMesh thin(mesh.triangles, mesh.vertices, 1);
  for (std::size_t f = 0; f < 8; ++f) EXPECT_EQ(thin.normal[f], Vec3{});
}

TEST(FacetMesh, OpenSurfacesAreRefused) {
  Mesh mesh = octahedron().mesh;
  mesh.triangles.pop_back();
  EXPECT_THROW(FacetMesh(mesh.triangles, mesh.vertices, 1), Failure);
}

TEST(FacetMesh, MarksSpreadRingByRing) {
  const Shape shape = icosahedron();
  const FacetMesh mesh(shape.mesh.triangles, shape.mesh.vertices, 1);
  const auto marks_after = [&](int rings) {
    std::vector<std::uint8_t> marked(12, 0);
    marked[0] = 1;
    spread(mesh.facets, rings, marked);
    return std::count(marked.begin(), marked.end(), 1);
  };
  EXPECT_EQ(marks_after(0), 1);
  EXPECT_EQ(marks_after(1), 6);
  EXPECT_EQ(marks_after(2), 11);
  EXPECT_EQ(marks_after(3), 12);
  const auto bends = [&](double angle) {
    const std::vector<std::uint8_t> marked = at_bends(mesh, angle, 12);
    return std::count(marked.begin(), marked.end(), 1);
  };
  EXPECT_EQ(bends(0.7), 12);  // it turns by 41.8 degrees
  EXPECT_EQ(bends(0.75), 0);
}

TEST(Sense, SmoothSurfacesHaveNoSampleWithTwo) {
  for (const char* name : {"sphere", "torus"})
    for (const std::size_t n : {500u, 2000u})
      for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const FirstSurface s(make_shape(name), n, 1, seed);
        std::size_t two = 0;
        for (Index v = 0; v < s.points.size(); ++v) two += s.sensed.at(v).size() > 1;
        EXPECT_EQ(two, 0u) << name << " " << n << " " << seed;
      }
}

// What is sensed of a polyhedron without a sample on an edge.
struct Faces {
  std::size_t near = 0;     // samples within a spacing of an edge
  std::size_t nothing = 0;  // of those, no surface
  std::size_t wrong = 0;    // of those, a surface that is none of its face
};

Faces faces_of(const Shape& shape, std::size_t n) {
  const FirstSurface s(shape, n);
  const Creases creases(shape.mesh);
  Faces faces;
  for (Index v = 0; v < s.points.size(); ++v) {
    if (creases.distance_from(s.points[v]) > s.spacing[v]) continue;
    ++faces.near;
    faces.nothing += s.sensed.at(v).empty();
    for (const LocalSurface& o : s.sensed.at(v)) {
      const bool is_face = std::any_of(
          shape.mesh.triangles.begin(), shape.mesh.triangles.end(), [&](const Triangle& t) {
            const Vec3 a = shape.mesh.vertices[t[0]], b = shape.mesh.vertices[t[1]],
                       c = shape.mesh.vertices[t[2]];
            const Vec3 normal = cross(b - a, c - a);
            return distance_to_triangle(s.points[v], a, b, c) < 1e-9 &&
                   length(o.normal(s.points[v]) - (1 / length(normal)) * normal) < 1e-6;
          });
      if (is_face) continue;
      ++faces.wrong;
      break;
    }
  }
  return faces;
}

// Measured: 0.6 to 2.6 % have a surface beside or in place of their face's, as where a corner
// bevels three faces at once.
TEST(Sense, SamplesBesideAnEdgeKnowTheirFace) {
  for (const char* name :
       {"cube", "l_bracket", "octahedron", "perforated_cube", "two_cubes", "hexagonal_prism"}) {
    const Faces f = faces_of(make_shape(name), 3000);
    EXPECT_GT(f.near, 500u) << name;
    EXPECT_EQ(f.nothing, 0u) << name;
    EXPECT_LT(static_cast<double>(f.wrong), 0.035 * static_cast<double>(f.near)) << name;
  }
}

TEST(Sense, SamplesOnEdgesAndCornersHaveTwoAndThree) {
  const Shape shape = cube();
  PointCloud cloud;
  cloud.positions = sample_feature(shape.mesh, 2000, 1);
  const Result<Reconstruction> r = reconstruct(cloud, unsharpened());
  ASSERT_TRUE(r);
  const FirstSurface s(r->mesh, 1);
  const Creases creases(shape.mesh);
  std::size_t corners = 0, edges = 0, right = 0;
  for (Index v = 0; v < s.points.size(); ++v) {
    if (creases.distance_from(s.points[v]) > 1e-12) continue;
    ++edges;
    const bool corner = std::any_of(creases.corners().begin(), creases.corners().end(),
                                    [&](Vec3 c) { return distance(c, s.points[v]) < 1e-12; });
    corners += corner && s.sensed.at(v).size() == 3;
    right += s.sensed.at(v).size() == (corner ? 3u : 2u);
  }
  EXPECT_EQ(corners, 8u);
  EXPECT_EQ(right, edges);
}

TEST(Sense, DoesNotDependOnThreads) {
  const Mesh mesh = bevelled_mesh(make_shape("cylinder"), 3000, 1);
  const FirstSurface one(mesh, 1), five(mesh, 5);
  EXPECT_EQ(one.sensed.first, five.sensed.first);
  ASSERT_EQ(one.sensed.surface.size(), five.sensed.surface.size());
  ASSERT_GT(one.sensed.surface.size(), 100u);
  for (std::size_t i = 0; i < one.sensed.surface.size(); ++i) {
    EXPECT_EQ(one.sensed.surface[i].c, five.sensed.surface[i].c);
    EXPECT_EQ(one.sensed.surface[i].n, five.sensed.surface[i].n);
  }
}

// Nothing bends by more than 8 degrees there.
TEST(Sense, NoFeatureIsSoughtAmidAFace) {
  const FirstSurface s(make_shape("cube"), 3000);
  const Creases creases(make_shape("cube").mesh);
  std::size_t inner = 0;
  for (Index v = 0; v < s.points.size(); ++v) {
    if (creases.distance_from(s.points[v]) < 5 * s.spacing[v]) continue;
    ++inner;
    EXPECT_TRUE(s.sensed.at(v).empty());
  }
  EXPECT_GT(inner, 500u);
}

}  // namespace
}  // namespace arris
