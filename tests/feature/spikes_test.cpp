#include "feature/spikes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/vec.h"
#include "support/job.h"
#include "support/revolution.h"
#include "support/shapes.h"

namespace arris {
namespace {

using namespace test;

std::vector<Index> spikes_of(const Mesh& mesh, const std::vector<double>& spacing) {
  OneStageJob job;
  const std::vector<std::uint8_t> spike = find_spikes(mesh.vertices, mesh.triangles, spacing, job);
  std::vector<Index> list;
  for (Index v = 0; v < spike.size(); ++v)
    if (spike[v]) list.push_back(v);
  return list;
}

std::vector<Index> spikes_of(const Mesh& mesh) {
  return spikes_of(mesh, std::vector<double>(mesh.vertices.size(), 1));
}

// A terrain over an n x n grid of spacing 1: height(x, y), open at its border.
template <class Height>
Mesh terrain(Index n, Height&& height) {
  Mesh mesh;
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x)
      mesh.vertices.push_back({static_cast<double>(x), static_cast<double>(y), height(x, y)});
  for (Index y = 0; y + 1 < n; ++y)
    for (Index x = 0; x + 1 < n; ++x) {
      const Index v = y * n + x;
      mesh.triangles.push_back({v, v + 1, v + n + 1});
      mesh.triangles.push_back({v, v + n + 1, v + n});
    }
  return mesh;
}

constexpr Index side = 20;
constexpr Index inner = 10 * side + 9;  // a vertex amidst the terrain

double slope(Index x, Index) {
  return 0.3 * x;
}
double roof(Index x, Index) {
  return -std::abs(x - 9.0);
}
double bowl(Index x, Index y) {
  return 0.01 * ((x - 9.0) * (x - 9.0) + (y - 9.0) * (y - 9.0));
}

TEST(Spikes, SmoothAndCreasedSurfacesHaveNone) {
  EXPECT_TRUE(spikes_of(terrain(side, slope)).empty());
  EXPECT_TRUE(spikes_of(terrain(side, roof)).empty());
  EXPECT_TRUE(spikes_of(terrain(side, bowl)).empty());
}

// The shortest edge at every vertex.
std::vector<double> shortest_edges(const Mesh& mesh) {
  std::vector<double> shortest(mesh.vertices.size(), 1e9);
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      for (const Index v : {t[k], t[(k + 1) % 3]})
        shortest[v] =
            std::min(shortest[v], distance(mesh.vertices[t[k]], mesh.vertices[t[(k + 1) % 3]]));
  return shortest;
}

// Not the cylinder: the centre of a cap that has no other samples than its rim could be anything.
TEST(Spikes, ShapesWithTipsCornersAndEdgesHaveNone) {
  for (const Shape& shape : all_shapes())
    if (shape.name != "cylinder") {
      EXPECT_TRUE(spikes_of(shape.mesh, shortest_edges(shape.mesh)).empty()) << shape.name;
    }
}

// A rim, an apex and the centre of the base: nothing else says where the cone ends.
TEST(Spikes, TheApexOfAConeSampledAtItsRimIsNone) {
  const Mesh cone = revolve({{0, 0}, {1, 0}, {0, 2}}, 60);
  EXPECT_TRUE(spikes_of(cone, std::vector<double>(cone.vertices.size(), 0.1)).empty());
}

TEST(Spikes, OneIsFoundOnAPlaneARoofAndABowl) {
  for (const double height : {0.5, -0.5, 1., 3.}) {
    const auto raised = [&](auto&& ground) {
      Mesh mesh = terrain(side, ground);
      mesh.vertices[inner].z += height;
      return spikes_of(mesh);
    };
    EXPECT_EQ(raised(slope), std::vector<Index>{inner}) << height;
    EXPECT_EQ(raised(bowl), std::vector<Index>{inner}) << height;
  }
  Mesh mesh = terrain(side, roof);
  mesh.vertices[inner].z += 1;  // on the ridge
  EXPECT_EQ(spikes_of(mesh), std::vector<Index>{inner});
}

TEST(Spikes, APointLeftAsideIsFoundToo) {
  Mesh mesh = terrain(side, slope);
  mesh.vertices.push_back({9.3, 10.2, 0.3 * 9.3});       // in the plane
  mesh.vertices.push_back({5.4, 6.3, 0.3 * 5.4 + 1.5});  // above it
  EXPECT_EQ(spikes_of(mesh), std::vector<Index>{side * side + 1});
}

TEST(Spikes, APartThatTheSurfaceMissedIsNone) {
  Mesh mesh = terrain(side, slope);
  for (double x : {9.3, 9.8, 10.3}) mesh.vertices.push_back({x, 10.2, 0.3 * x + 2});
  EXPECT_TRUE(spikes_of(mesh).empty());
}

TEST(Spikes, RoughGroundHidesNoneOfItsSamples) {
  // Heights of up to half a spacing without pattern.
  const auto rough = [](Index x, Index y) { return 0.5 * std::sin(12.9898 * x + 78.233 * y * y); };
  EXPECT_TRUE(spikes_of(terrain(side, rough)).empty());
}

TEST(Spikes, WithoutASurfaceThereIsNone) {
  Mesh points;
  points.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(spikes_of(points).empty());
}

}  // namespace
}  // namespace arris
