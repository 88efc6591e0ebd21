// arris check on meshes with every kind of defect, and on good ones.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "cli/workplace.h"

namespace arris::test {
namespace {

struct Row {
  const char* name;
  const char* file;
  std::string content;
  int exit_code;
  const char* message;  // empty if the mesh is certified
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.name;
}

std::string off(int vertices, int faces, const std::string& body) {
  return "OFF\n" + std::to_string(vertices) + " " + std::to_string(faces) + " 0\n" + body;
}

const std::string corners = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const std::string inverted = "3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";
// A second tetrahedron whose corner 5 lies inside the first.
const std::string pierced = "0.9 0.9 0.9\n0.1 0.1 0.1\n2 1 1\n1 2 1\n";
const std::string second = "3 4 5 6\n3 4 7 5\n3 4 6 7\n3 5 7 6\n";

const Row rows[] = {
    {"Tetrahedron", "m.off", off(4, 4, corners + faces), 0, ""},
    {"Open", "m.off", off(4, 3, corners + "3 0 2 1\n3 0 1 3\n3 0 3 2\n"), 8,
     "'m.off' fails the check: edge 1-2 has only one triangle"},
    {"Inverted", "m.off", off(4, 4, corners + inverted), 8,
     "'m.off' fails the check: the component of triangle 0 has its normals pointing inwards"},
    {"Misoriented", "m.off", off(4, 4, corners + "3 0 1 2\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"), 8,
     "'m.off' fails the check: both triangles at edge 0-1 walk it in the same direction"},
    {"NonmanifoldEdge", "m.off",
     off(5, 7, corners + "1 1 -1\n" + faces + "3 0 1 4\n3 1 0 4\n3 0 4 1\n"), 8,
     "'m.off' fails the check: edge 0-1 has 5 triangles"},
    {"NonmanifoldVertex", "m.off",
     off(7, 8,
         corners + "-1 0 0\n0 -1 0\n0 0 -1\n" + faces + "3 0 4 5\n3 0 6 4\n3 0 5 6\n3 4 6 5\n"),
     8, "'m.off' fails the check: the triangles round vertex 0 form 2 fans"},
    {"SelfIntersecting", "m.off", off(8, 8, corners + pierced + faces + second), 8,
     "'m.off' fails the check: triangles ..."},
    {"Degenerate", "m.off", off(4, 4, "0 0 0\n1 0 0\n2 0 0\n0 0 1\n" + faces), 8,
     "'m.off' fails the check: the corners of triangle 0 lie on one line"},
    {"RepeatedCorner", "m.off", off(4, 5, corners + faces + "3 0 0 1\n"), 8,
     "'m.off' fails the check: triangle 4 has the same corner twice"},
    {"NonFinite", "m.off", off(4, 4, "nan 0 0\n1 0 0\n0 1 0\n0 0 1\n" + faces), 8,
     "'m.off' fails the check: vertex 0 is not finite; its geometry was not examined"},
    {"NoFaces", "m.off", off(4, 0, corners), 3, "'m.off': holds points, but no faces"},
    {"NoVertices", "m.off", off(0, 0, ""), 5, "'m.off': holds no vertices"},
    {"IndexTooHigh", "m.off", off(4, 1, corners + "3 0 1 9\n"), 3,
     "'m.off': line 7, face 0: names vertex 9, but there are 4, numbered from 0"},
    {"FacesCutOff", "m.off", off(4, 4, corners + "3 0 2 1\n"), 3, "'m.off': ..."},
    {"Points", "m.xyz", corners, 4,
     "'m.xyz': meshes are not read from files with the extension '.xyz'"},
    {"StlGarbage", "m.stl", "soli", 3, "'m.stl': is neither an ascii nor a binary STL file"},
    {"Empty", "m.ply", "", 3, "'m.ply': is empty"},
};

class CheckMesh : public testing::TestWithParam<Row> {};

TEST_P(CheckMesh, NamesTheFirstDefect) {
  const Row& row = GetParam();
  const Workplace place;
  place.write(row.file, row.content);
  const Outcome outcome = place.arris("check --quiet " + std::string(row.file));
  EXPECT_EQ(outcome.exit_code, row.exit_code) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(matches(printed_error(outcome.err).message, row.message)) << outcome.err;
  EXPECT_EQ(outcome.err.empty(), row.exit_code == 0);
}

INSTANTIATE_TEST_SUITE_P(Table, CheckMesh, testing::ValuesIn(rows),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(CheckMesh, PrintsTheCertificate) {
  const Workplace place;
  place.write("m.off", off(4, 4, corners + faces));
  const Outcome outcome = place.arris("check m.off");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.out.starts_with("m.off: certified\n")) << outcome.out;
  EXPECT_NE(outcome.out.find("  triangles              4\n"), std::string::npos) << outcome.out;
}

TEST(CheckMesh, PrintsTheCertificateAsJson) {
  const Workplace place;
  place.write("m.off", off(4, 3, corners + "3 0 2 1\n3 0 1 3\n3 0 3 2\n"));
  const Outcome outcome = place.arris("check --json m.off");
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_TRUE(outcome.out.starts_with("{\n  \"ok\": false,\n  \"closed\": false,\n"))
      << outcome.out;
  EXPECT_NE(outcome.out.find("\"boundary_edges\": 3,\n"), std::string::npos) << outcome.out;
  EXPECT_TRUE(outcome.out.ends_with("\n}\n")) << outcome.out;
}

}  // namespace
}  // namespace arris::test
