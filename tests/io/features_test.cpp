// Feature curves in files: what was written is there, whatever the format.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

#include "arris/features.h"
#include "io/ply_body.h"
#include "io/ply_format.h"
#include "support.h"

namespace arris::test {
namespace {

using Json = nlohmann::json;

// Six vertices, of which 0 is on no curve: a chain 1-2-3 and a ring 3-4-5, which meet at 3.
Mesh points() {
  Mesh mesh;
  mesh.vertices = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {2, 0.1, 0}, {3, 1, 0}, {3, -1, 1e-300}};
  mesh.triangles = {{1, 2, 3}, {3, 4, 5}};
  return mesh;
}

FeatureNetwork network() {
  FeatureNetwork n;
  n.curves.push_back({{1, 2, 3}, false, CurveKind::convex, 2, 90.5, 80});
  n.curves.push_back({{3, 4, 5}, true, CurveKind::concave, 5, 250, 270});
  n.corners = {{1, {0, 0, 0}, 1}, {3, {2, 0.1, 0}, 3}};
  n.patch = {0, 1};
  n.patches = 2;
  return n;
}

std::string written(const std::string& name, const Mesh& mesh, const FeatureNetwork& n) {
  const TempDirectory directory;
  const auto done = write_features(directory.path(name), mesh, n);
  EXPECT_TRUE(done) << done.error().message;
  EXPECT_EQ(directory.entries(), std::vector<std::string>{name});
  return directory.load(name);
}

TEST(WriteFeatures, ObjHasPolylinesAndCorners) {
  EXPECT_EQ(written("c.obj", points(), network()),
            "v 0 0 0\nv 1 0 0\nv 2 0.1 0\nv 3 1 0\nv 3 -1 1e-300\n"
            "g curve_0 convex\nl 1 2 3\ng curve_1 concave\nl 3 4 5 3\ng corners\np 1 3\n");
}

TEST(WriteFeatures, JsonHasAnglesKindsAndPositions) {
  const Json json = Json::parse(written("c.JSON", points(), network()));
  ASSERT_EQ(json["curves"].size(), 2u);
  EXPECT_EQ(json["curves"][0]["kind"], "convex");
  EXPECT_EQ(json["curves"][0]["closed"], false);
  EXPECT_EQ(json["curves"][0]["mean_angle"], 90.5);
  EXPECT_EQ(json["curves"][0]["sharpest_angle"], 80);
  EXPECT_EQ(json["curves"][1]["kind"], "concave");
  EXPECT_EQ(json["curves"][1]["vertices"], Json::array({3, 4, 5}));
  EXPECT_EQ(json["curves"][1]["positions"][2], Json::array({3, -1, 1e-300}));
  EXPECT_EQ(json["corners"][1]["degree"], 3);
  EXPECT_EQ(json["corners"][1]["position"], Json::array({2, 0.1, 0}));
  EXPECT_EQ(json["patches"], 2);
}

TEST(WriteFeatures, PlyHasVerticesAndEdges) {
  const std::string bytes = written("c.ply", points(), network());
  const Context context;
  Job job(context);
  job.stage("read", 1);
  const Source source{"c.ply", bytes, job};
  const PlyHeader header = parse_ply_header(source);
  ASSERT_EQ(header.elements.size(), 2u);
  EXPECT_EQ(header.elements[0].count, 5u);
  EXPECT_EQ(header.elements[1].name, "edge");
  EXPECT_EQ(header.elements[1].count, 5u);
  BinaryBody body(source, header);
  const auto row = [&](const PlyElement& element) {
    std::vector<double> values;
    body.begin_row(element, 0);
    for (const PlyProperty& p : element.properties) values.push_back(body.scalar(p.type));
    return values;
  };
  std::vector<std::vector<double>> vertices, edges;
  for (int k = 0; k < 5; ++k) vertices.push_back(row(header.elements[0]));
  for (int k = 0; k < 5; ++k) edges.push_back(row(header.elements[1]));
  EXPECT_FALSE(body.has_more());
  EXPECT_EQ(vertices[2], (std::vector<double>{2, 0.1, 0, 3, 3}));
  EXPECT_EQ(vertices[4], (std::vector<double>{3, -1, 1e-300, 5, 0}));
  EXPECT_EQ(edges, (std::vector<std::vector<double>>{{0, 1, 0, 90.5, 0},
                                                     {1, 2, 0, 90.5, 0},
                                                     {2, 3, 1, 250, 1},
                                                     {3, 4, 1, 250, 1},
                                                     {4, 2, 1, 250, 1}}));
}

TEST(WriteFeatures, WithoutCurvesFilesAreEmptyButValid) {
  EXPECT_EQ(written("c.obj", points(), {}), "");
  const Json json = Json::parse(written("c.json", points(), {}));
  EXPECT_TRUE(json["curves"].empty() && json["corners"].empty());
  EXPECT_NE(written("c.ply", points(), {}).find("element edge 0\n"), std::string::npos);
}

TEST(WriteFeatures, RefusesWhatDoesNotFit) {
  const TempDirectory directory;
  FeatureNetwork strange = network();
  strange.curves[1].vertices[0] = 6;
  EXPECT_EQ(write_features(directory.path("c.ply"), points(), strange).error().code,
            ErrorCode::usage);
  EXPECT_EQ(write_features(directory.path("c.stl"), points(), network()).error().code,
            ErrorCode::unsupported);
  EXPECT_EQ(directory.entries(), std::vector<std::string>{});
}

TEST(WriteMesh, ObjHasPatchesAsGroups) {
  Mesh mesh = points();
  mesh.triangles.push_back({1, 2, 4});
  mesh.face_attributes = {{"patch", ScalarType::i32, {1, 0, 1}}};
  const TempDirectory directory;
  ASSERT_TRUE(write_mesh(directory.path("m.obj"), mesh));
  const std::string text = directory.load("m.obj");
  EXPECT_TRUE(text.ends_with("g patch_0\nf 4 5 6\ng patch_1\nf 2 3 4\nf 2 3 5\n")) << text;
}

TEST(WriteMesh, RefusesFaceAttributesThatDoNotFit) {
  Mesh mesh = points();
  mesh.face_attributes = {{"patch", ScalarType::i32, {1}}};
  const TempDirectory directory;
  EXPECT_EQ(write_mesh(directory.path("m.ply"), mesh).error().code, ErrorCode::usage);
}

TEST(ReadMesh, KeepsFaceAttributesOfTrianglesAlone) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty uchar before\nproperty list uchar int "
      "vertex_indices\nproperty list uchar int other\nproperty float after\nend_header\n"
      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const auto triangles = mesh_of("m.ply", head + "7 3 0 1 2 2 5 5 0.5\n8 3 0 2 3 0 1.5\n");
  ASSERT_TRUE(triangles);
  ASSERT_EQ(triangles->face_attributes.size(), 2u);
  EXPECT_TRUE(same(triangles->face_attributes[0], {"before", ScalarType::u8, {7, 8}}));
  EXPECT_TRUE(same(triangles->face_attributes[1], {"after", ScalarType::f32, {0.5, 1.5}}));
  const auto polygons = mesh_of("m.ply", head + "7 4 0 1 2 3 2 5 5 0.5\n8 3 0 2 3 0 1.5\n");
  ASSERT_TRUE(polygons);
  EXPECT_EQ(polygons->triangles.size(), 3u);
  EXPECT_TRUE(polygons->face_attributes.empty());
}

}  // namespace
}  // namespace arris::test
