// arris model and arris sample: what they accept, refuse and write. What models and samples are
// like is tested in tests/truth.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "cli/refusal.h"

namespace arris::test {
namespace {

TEST(ModelCommand, ListsModelsOfWhichEachCanBeMade) {
  const Workplace place;
  const Outcome list = place.arris("model --list");
  EXPECT_EQ(list.exit_code, 0) << list.err;
  for (const char* name : {"two_cubes ", "male_symbol ", "bolt ", "nested_shells ", "csg "})
    EXPECT_NE(list.out.find(name), std::string::npos) << name;
  const Outcome outcome = place.arris("model nested_shells -o m.ply");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("3 components, Euler 6; certified"), std::string::npos) << outcome.out;
  EXPECT_EQ(place.arris("check m.ply --quiet").exit_code, 0);
}

TEST(ModelCommand, RandomSolidsAreTheSameEveryTime) {
  const Workplace place;
  const std::string options = " --resolution 24 --unit --json -o ";
  const Outcome first = place.arris("model csg --seed 3" + options + "a.ply");
  const Outcome again = place.arris("model csg --seed 3" + options + "b.ply");
  const Outcome other = place.arris("model csg --seed 4" + options + "c.ply");
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.out, again.out);
  EXPECT_NE(first.out, other.out);
  EXPECT_EQ(place.read("a.ply"), place.read("b.ply"));
  EXPECT_NE(place.read("a.ply"), place.read("c.ply"));
  for (const char* key : {"\"recipe\"", "\"seed\": 3", "\"wall\"", "\"dense_samples\""})
    EXPECT_NE(first.out.find(key), std::string::npos) << key;
}

TEST(SampleCommand, SpoilsTheSamplesAsAsked) {
  const Workplace place;
  ASSERT_EQ(place.arris("model l_bracket -o m.off --quiet").exit_code, 0);
  const std::string options = "sample m.off -n 900 --seed 7 -q ";
  for (const char* mode : {"uniform", "blue", "feature", "graded", "scan"}) {
    SCOPED_TRACE(mode);
    const std::string line = options + "--mode " + mode + " -o ";
    const Outcome outcome = place.arris(line + "a.ply");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "");
    ASSERT_EQ(place.arris(line + "b.ply").exit_code, 0);
    EXPECT_EQ(place.read("a.ply"), place.read("b.ply"));
    const std::string header = place.read("a.ply").substr(0, 200);
    EXPECT_NE(header.find("element vertex 900\nproperty float x"), std::string::npos) << header;
  }
  const Outcome spoilt = place.arris(
      "sample m.off -n 900 --noise 0.2h --outliers 5% --missing 2 --missing-radius 0.1 -o c.ply");
  EXPECT_EQ(spoilt.exit_code, 0) << spoilt.err;
  EXPECT_NE(spoilt.out.find(" outliers, "), std::string::npos) << spoilt.out;
  EXPECT_NE(spoilt.out.find(" missing\n"), std::string::npos) << spoilt.out;
}

// Units are told apart: 1 % of the diagonal, 0.01 of it, and spacings.
TEST(SampleCommand, ReadsSharesAndSpacings) {
  const Workplace place;
  ASSERT_EQ(place.arris("model cube -o m.ply --quiet").exit_code, 0);
  const auto cloud = [&](const std::string& noise) {
    const Outcome outcome = place.arris("sample m.ply -n 50 -q -o p.ply --noise " + noise);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return place.read("p.ply");
  };
  EXPECT_EQ(cloud("1%"), cloud("0.01"));
  EXPECT_NE(cloud("1%"), cloud("1h"));
  EXPECT_EQ(cloud("0"), cloud("0h"));
}

TEST(SampleCommand, CloudsComeBackAsTheModel) {
  const Workplace place;
  const Outcome outcome = place.shell(
      "$ARRIS model perforated_cube -o m.ply -q && "
      "$ARRIS sample m.ply -n 2500 --mode feature -o p.ply -q && "
      "$ARRIS reconstruct p.ply -o r.ply -q && $ARRIS check r.ply --json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\"euler\": -8"), std::string::npos) << outcome.out;
}

const Refusal rows[] = {
    {"ModelWithoutName", "model -o out.ply", 2, "name is required"},
    {"ModelWithoutOutput", "model cube", 2, "--output is required"},
    {"ModelUnknown", "model teapot -o out.ply", 2, "there is no model 'teapot'"},
    {"ModelSeedOfAFixedOne", "model cube --seed 2 -o out.ply", 2,
     "--seed is for the model csg only"},
    {"ModelSeedNegative", "model csg --seed -1 -o out.ply", 2,
     "--seed: must be a whole number from 0 to 1000000000000, not '-1'"},
    {"ModelResolution", "model cone --resolution 3 -o out.ply", 2,
     "--resolution: must be a whole number from 24 to 1024, not '3'"},
    {"ModelFormat", "model cube -o out.stp", 4, "..."},
    {"ModelNowhere", "model cube -o none/out.ply", 10, "..."},
    {"SampleWithoutMesh", "sample -n 10 -o out.ply", 2, "mesh is required"},
    {"SampleWithoutOutput", "sample m.off -n 10", 2, "--output is required"},
    {"SampleWithoutNumber", "sample m.off -o out.ply", 2, "--samples is required"},
    {"SampleNone", "sample m.off -n 0 -o out.ply", 2,
     "--samples: must be a whole number from 1 to 20000000, not '0'"},
    {"SampleMode", "sample m.off -n 10 --mode red -o out.ply", 2,
     "--mode: must be one of uniform|blue|feature|graded|scan, not 'red'"},
    {"SampleNoise", "sample m.off -n 10 --noise -1% -o out.ply", 2,
     "--noise: must be a share from 0 to 1 of the diagonal (or spacings, such as 0.2h), such as "
     "5% or 0.05, not '-1%'"},
    {"SampleNoiseNan", "sample m.off -n 10 --noise nan -o out.ply", 2, "--noise: must be ..."},
    {"SampleNoiseSpacings", "sample m.off -n 10 --noise 101h -o out.ply", 2,
     "--noise: must be from 0h to 100h, such as 0.2h, not '101h'"},
    {"SampleNoiseDirection", "sample m.off -n 10 --noise-direction up -o out.ply", 2,
     "--noise-direction: must be one of normal|ray|isotropic, not 'up'"},
    {"SampleRayWithoutScan", "sample m.off -n 10 --noise-direction ray -o out.ply", 2,
     "only a scan has rays along which noise can act"},
    {"SampleNormalOfScan", "sample m.off -n 10 --mode scan --noise-direction normal -o out.ply", 2,
     "a scan has noise along its rays, not along normals"},
    {"SampleOutliers", "sample m.off -n 10 --outliers many -o out.ply", 2,
     "--outliers: must be a share from 0 to 10, such as 5% or 0.05, not 'many'"},
    {"SampleMissing", "sample m.off -n 10 --missing -1 -o out.ply", 2,
     "--missing: must be a whole number from 0 to 1000, not '-1'"},
    {"SampleViews", "sample m.off -n 10 --mode scan --views 0 -o out.ply", 2,
     "--views: must be a whole number from 1 to 1000, not '0'"},
    {"SampleFormat", "sample m.off -n 10 -o out.stl", 4, "..."},
    {"SampleOverItself", "sample m.off -n 10 -o m.off", 2,
     "'m.off': the cloud would overwrite the input"},
    {"SampleNoSuchFile", "sample none.off -n 10 -o out.ply", 3, "..."},
    {"SampleOfPoints", "sample p.off -n 10 -o out.ply", 3, "..."},
    {"SampleOfALine", "sample line.off -n 10 -o out.ply", 6,
     "there is nothing to sample: the area of the mesh is zero or out of range"},
    {"SampleAllMissing", "sample m.off -n 10 --missing 1 --missing-radius 1 -o out.ply", 6,
     "there is nothing to sample: the missing patches leave no samples"},
};

class BadTruth : public testing::TestWithParam<Refusal> {};

TEST_P(BadTruth, IsRefused) {
  const Workplace place;
  place.write("m.off",
              "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  place.write("line.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  place.write("p.off", "OFF\n2 0 0\n0 0 0\n1 0 0\n");
  expect_refused(place, "", GetParam());
}

INSTANTIATE_TEST_SUITE_P(Table, BadTruth, testing::ValuesIn(rows), name_of);

}  // namespace
}  // namespace arris::test
