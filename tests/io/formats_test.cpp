// OFF, OBJ and STL as they are found in the wild.
#include <gtest/gtest.h>

#include <cstring>

#include "support.h"

namespace arris::test {
namespace {

using Triangles = std::vector<Triangle>;

TEST(Off, ReadsCountsOnEitherLineAndComments) {
  for (const char* start : {"OFF\n4 2 0\n", "OFF 4 2 0\n", "# a\nOFF # b\n\n# c\n4 2 # d\n"}) {
    const auto mesh = mesh_of("m.off", std::string(start) +
                                           "0 0 0\n1 0 0\n1 1 0 # corner\n\n0 1 0\n"
                                           "4 0 1 2 3 255 0 0\n3 2 1 0\n");
    ASSERT_TRUE(mesh) << start << mesh.error().message;
    EXPECT_EQ(mesh->vertices.size(), 4u);
    EXPECT_EQ(mesh->triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {2, 1, 0}}));
  }
}

TEST(Off, ReadsColoursAndNormals) {
  const auto colours = points_of("c.off", "COFF\n2 0 0\n1 2 3 10 20 30 255\n4 5 6 1 2 3 0\n");
  ASSERT_TRUE(colours) << colours.error().message;
  ASSERT_EQ(colours->attributes.size(), 4u);
  EXPECT_EQ(colours->attributes[1], (Attribute{"green", ScalarType::u8, {20, 2}}));
  EXPECT_EQ(colours->attributes[3].name, "alpha");
  const auto both = points_of("c.off", "NCOFF 1 0 0\n1 2 3 0 0 1 0.5 0.25 1\n");
  ASSERT_TRUE(both) << both.error().message;
  ASSERT_EQ(both->attributes.size(), 6u);
  EXPECT_EQ(both->attributes[2], (Attribute{"nz", ScalarType::f64, {1}}));
  EXPECT_EQ(both->attributes[3], (Attribute{"red", ScalarType::f64, {0.5}}));
}

TEST(Off, PointsDoNotNeedSoundFaces) {
  const auto cloud = points_of("c.off", "OFF\n1 7 0\n1 2 3\nrubbish\n");
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->warnings.size(), 1u);
}

TEST(Obj, ReadsEveryKindOfFace) {
  const auto mesh = mesh_of("m.obj",
                            "# cube\nmtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nv 1 1 0\n"
                            "vt 0 0\nv 0 1 0\nf 1 2 3\nf 1/1 2/1 3/1 4/1\nf 1//1 2//1 3//1\n"
                            "f 1/1/1 \\\n 2/1/1 3/1/1\nf -4 -3 -2\nl 1 2\nf 5 1 2\nv 2 2 2\n");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->vertices.size(), 5u);
  EXPECT_EQ(
      mesh->triangles,
      (Triangles{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 1, 2}, {0, 1, 2}, {4, 0, 1}}));
}

TEST(Obj, ReadsColoursOfAllKinds) {
  const auto bytes = points_of("c.obj", "v 0 0 0 255 128 0\nv 1 1 1 3 4 5\n");
  ASSERT_TRUE(bytes);
  EXPECT_EQ(bytes->attributes.at(0), (Attribute{"red", ScalarType::u8, {255, 3}}));
  const auto parts = points_of("c.obj", "v 0 0 0 1 1 0 0.2\nv 1 1 1 1 0.4 1 0\n");
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->attributes.at(0), (Attribute{"red", ScalarType::u8, {255, 102}}));
  const auto exact = points_of("c.obj", "v 0 0 0 1 0.123 0.2\n");
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->attributes.at(1), (Attribute{"green", ScalarType::f64, {0.123}}));
  const auto some = points_of("c.obj", "v 0 0 0 1 1 1\nv 1 1 1\n");
  ASSERT_TRUE(some);
  EXPECT_TRUE(some->attributes.empty());
  EXPECT_EQ(some->warnings.size(), 1u);
}

// Two triangles that share an edge; all corners written out.
std::string ascii_stl() {
  return "solid two triangles\r\n"
         "  facet normal 0 0 1\r\n outer loop\r\n vertex 0 0 0\r\n vertex 1 0 0\r\n"
         "  VERTEX 1e0 1 -0\r\n endloop\r\n endfacet\r\n"
         "  facet normal 0 0 1\r\n outer loop\r\n vertex 0 0 0\r\n vertex 1 1 0\r\n"
         "  vertex 0 0.1 0\r\n endloop\r\n endfacet\r\nendsolid two triangles\r\n";
}

std::string binary_stl(const std::string& header, const std::vector<float>& corners) {
  std::string bytes = header + std::string(80 - header.size(), '\0');
  const auto count = static_cast<std::uint32_t>(corners.size() / 9);
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (std::size_t t = 0; t < count; ++t) {
    bytes.append(12, '\0');
    bytes.append(reinterpret_cast<const char*>(&corners[9 * t]), 36);
    bytes.append(2, '\7');
  }
  return bytes;
}

TEST(Stl, JoinsIdenticalCorners) {
  const auto ascii = mesh_of("m.stl", ascii_stl());
  ASSERT_TRUE(ascii) << ascii.error().message;
  EXPECT_EQ(ascii->triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(ascii->vertices[3], (Vec3{0, 0.1, 0}));
  const std::vector<float> corners = {0, 0, 0, 1, 0, 0, 1, 1, -0.f, 0, 0, 0, 1, 1, 0, 0, 1, 0};
  // The second header looks like ascii.
  for (const char* header : {"binary", "solid binary\nfacet normal"}) {
    const auto binary = mesh_of("m.stl", binary_stl(header, corners));
    ASSERT_TRUE(binary) << binary.error().message;
    EXPECT_EQ(binary->triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(binary->vertices.size(), 4u);
    EXPECT_EQ(binary->position_type, ScalarType::f32);
  }
}

TEST(Stl, NeighbouringDoublesStayApart) {
  std::vector<float> corners;
  std::mt19937 random(1);
  std::vector<float> grid(40);
  for (std::size_t k = 0; k < grid.size(); ++k)
    grid[k] = k ? std::nextafter(grid[k - 1], 2.f) : 1.f;
  for (int k = 0; k < 9 * 3000; ++k) corners.push_back(grid[random() % grid.size()]);
  const auto mesh = mesh_of("m.stl", binary_stl("x", corners));
  ASSERT_TRUE(mesh);
  std::vector<Vec3> sorted = mesh->vertices;
  const auto less = [](Vec3 a, Vec3 b) {
    return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
  };
  std::sort(sorted.begin(), sorted.end(), less);
  EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
  for (std::size_t c = 0; c < corners.size() / 3; ++c) {
    const Vec3 p = mesh->vertices[mesh->triangles[c / 3][c % 3]];
    EXPECT_EQ(p, (Vec3{corners[3 * c], corners[3 * c + 1], corners[3 * c + 2]}));
  }
}

}  // namespace
}  // namespace arris::test
