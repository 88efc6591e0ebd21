// arris compare: what it prints, writes and refuses. The figures are tested in tests/compare.
#include <gtest/gtest.h>

#include <string>

#include "cli/refusal.h"

namespace arris::test {
namespace {

constexpr const char* tetrahedron =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
constexpr const char* taller =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1.1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
constexpr const char* open = "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CompareCommand, PrintsATable) {
  const Workplace place;
  place.write("result.off", taller);
  place.write("truth.off", tetrahedron);
  const Outcome outcome = place.arris("compare result.off truth.off --samples 2000");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* part : {"result.off against truth.off", "Chamfer", "Hausdorff", "within 0.1 %",
                           "90 degrees, 0.1 %", "corners", "EF1", "genus", "IoU"})
    EXPECT_TRUE(contains(outcome.out, part)) << part << " is missing in\n" << outcome.out;
}

TEST(CompareCommand, PrintsTheSameJsonForAnyThreads) {
  const Workplace place;
  place.write("result.off", taller);
  place.write("truth.off", tetrahedron);
  const std::string command =
      "compare --quiet --json result.off truth.off --samples 2000 --threads ";
  const Outcome one = place.arris(command + "1"), three = place.arris(command + "3");
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(one.err, "");
  EXPECT_EQ(one.out, three.out);
  for (const char* key :
       {"diagonal", "chamfer", "hausdorff", "fscore_0.005", "fscore_0.001", "normal_error_deg",
        "volume_iou", "same_topology", "edges_sweep", "corners", "ef1", "self_intersections"})
    EXPECT_TRUE(contains(one.out, std::string("\"") + key + "\":")) << key << " is missing";
  EXPECT_TRUE(contains(one.out, "\"same_topology\": true"));
}

TEST(CompareCommand, SaysWhatAnOpenMeshHasNot) {
  const Workplace place;
  place.write("result.off", open);
  place.write("truth.off", tetrahedron);
  const Outcome outcome = place.arris("compare result.off truth.off --samples 2000");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "note: the result has 3 edge(s)")) << outcome.out;
}

TEST(CompareCommand, WritesTheErrorMap) {
  const Workplace place;
  place.write("result.off", taller);
  place.write("truth.off", tetrahedron);
  const Outcome outcome =
      place.arris("compare --quiet result.off truth.off --samples 2000 --error-map map.ply");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
  const Outcome info = place.arris("info map.ply");
  EXPECT_TRUE(contains(info.out, "distance, float64, 0 .. 0.1")) << info.out;
  EXPECT_TRUE(contains(info.out, "blue, uint8")) << info.out;
}

#ifdef ARRIS_HAS_VIEWER
TEST(CompareCommand, DrawsBothMeshesAndALegend) {
  const Workplace place;
  place.write("result.off", taller);
  place.write("truth.off", tetrahedron);
  const Outcome outcome = place.arris(
      "compare --quiet result.off truth.off --samples 2000 --picture map.png --size 64x48");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string png = place.read("map.png");
  ASSERT_GT(png.size(), 24u);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(static_cast<unsigned char>(png[19]), 128);           // two panels
  EXPECT_EQ(static_cast<unsigned char>(png[23]), 48 + 32 + 32);  // captions and legend
}
#endif

const Refusal rows[] = {
    {"NoFiles", "", 2, "result is required"},
    {"NoTruth", "m.off", 2, "truth is required"},
    {"NoSuchFile", "m.off none.off", 3, "..."},
    {"NoTriangles", "p.off m.off", 3, "..."},
    {"NoArea", "m.off flat.off", 6, "no triangle of the truth has an area"},
    {"NotFinite", "nan.off m.off", 5,
     "vertex 1 of the result has a coordinate that is not a finite number, or beyond 1e150"},
    {"Samples", "m.off m.off --samples 10", 2,
     "--samples: must be a whole number from 1000 to 100000000, not '10'"},
    {"Dihedral", "m.off m.off --dihedral 200", 2,
     "--dihedral: must be a number from 1 to 180, not '200'"},
    {"FullScale", "m.off m.off --error-full 0", 2,
     "--error-full: must be a number from 1e-9 to 1, not '0'"},
    {"MapOverInput", "m.off m.ply --error-map m.ply", 2,
     "'m.ply': the error map would overwrite the input"},
    {"MapFormat", "m.off m.off --error-map map.stl", 4, "..."},
    {"Memory", "m.off m.off --memory-limit 1M", 9, "..."},
};

class BadCompare : public testing::TestWithParam<Refusal> {};

TEST_P(BadCompare, IsRefused) {
  const Workplace place;
  place.write("m.off", tetrahedron);
  place.write("m.ply", "not looked at");
  place.write("p.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 1\n");
  place.write("flat.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  place.write("nan.off", "OFF\n3 1 0\n0 0 0\nnan 0 0\n2 0 0\n3 0 1 2\n");
  expect_refused(place, "compare --quiet", GetParam());
}

INSTANTIATE_TEST_SUITE_P(Table, BadCompare, testing::ValuesIn(rows), name_of);

}  // namespace
}  // namespace arris::test
