// The table of command lines that are refused, all with exit code 2 and before any file is touched.
#include <gtest/gtest.h>

#include <string>

#include "cli/refusal.h"

namespace arris::test {
namespace {

const Refusal rows[] = {
    {"UnknownCommand", "rebuild in.xyz", 2, "the following arguments were not expected: ..."},
    {"NoInput", "reconstruct -o out.ply", 2, "input is required"},
    {"NoOutput", "reconstruct in.xyz", 2, "--output is required"},
    {"OutputWithoutName", "reconstruct in.xyz -o", 2, "--output: 1 required file missing"},
    {"EmptyOutput", "reconstruct in.xyz -o ''", 2, "--output: must name a file"},
    {"EmptyInput", "reconstruct '' -o out.ply", 2, "input: must name a file"},
    {"TwoInputs", "reconstruct in.xyz more.xyz -o out.ply", 2,
     "the following argument was not expected: more.xyz"},
    {"UnknownOption", "reconstruct in.xyz -o out.ply --sharp", 2,
     "the following argument was not expected: --sharp"},
    {"UnknownMethod", "reconstruct in.xyz -o out.ply --method magic", 2,
     "--method: must be one of default|paper, not 'magic'"},
    {"UnknownCurvature", "reconstruct in.xyz -o out.ply --curvature gauss", 2,
     "--curvature: must be one of area|cotangent|polyhedral, not 'gauss'"},
    {"LambdaNegative", "reconstruct in.xyz -o out.ply --lambda -1", 2,
     "--lambda: must be a number from 0 to 1000000, not '-1'"},
    {"LambdaNan", "reconstruct in.xyz -o out.ply --lambda nan", 2,
     "--lambda: must be a number from 0 to 1000000, not 'nan'"},
    {"LambdaInfinite", "reconstruct in.xyz -o out.ply --lambda inf", 2,
     "--lambda: must be a number from 0 to 1000000, not 'inf'"},
    {"NoiseNegative", "reconstruct in.xyz -o out.ply --noise -1", 2,
     "--noise: must be a number from 0, not '-1'"},
    {"LambdaWord", "reconstruct in.xyz -o out.ply --lambda much", 2,
     "--lambda: must be a number from 0 to 1000000, not 'much'"},
    {"CyclesZero", "reconstruct in.xyz -o out.ply --cycles 0", 2,
     "--cycles: must be a whole number from 1 to 100, not '0'"},
    {"CyclesNegative", "reconstruct in.xyz -o out.ply --cycles -1", 2,
     "--cycles: must be a whole number from 1 to 100, not '-1'"},
    {"CyclesHuge", "reconstruct in.xyz -o out.ply --cycles 99999999999999999999", 2,
     "--cycles: must be a whole number from 1 to 100, not '99999999999999999999'"},
    {"CyclesBroken", "reconstruct in.xyz -o out.ply --cycles 2.5", 2,
     "--cycles: must be a whole number from 1 to 100, not '2.5'"},
    {"BackgroundNegative", "reconstruct in.xyz -o out.ply --background -3", 2,
     "--background: must be a number from 0 to 1000, not '-3'"},
    {"BackgroundHuge", "reconstruct in.xyz -o out.ply --background 1e9", 2,
     "--background: must be a number from 0 to 1000, not '1e9'"},
    {"ThreadsNegative", "reconstruct in.xyz -o out.ply --threads -2", 2,
     "--threads: must be a whole number from 0 to 256, not '-2'"},
    {"ThreadsHuge", "reconstruct in.xyz -o out.ply --threads 100000", 2,
     "--threads: must be a whole number from 0 to 256, not '100000'"},
    {"MemoryWord", "reconstruct in.xyz -o out.ply --memory-limit lots", 2,
     "--memory-limit: must be a size such as 4G, 512M or 1000000, not 'lots'"},
    {"MemoryUnit", "reconstruct in.xyz -o out.ply --memory-limit 4X", 2,
     "--memory-limit: must be a size such as 4G, 512M or 1000000, not '4X'"},
    {"MemoryZero", "reconstruct in.xyz -o out.ply --memory-limit 0", 2,
     "--memory-limit: must be a size such as 4G, 512M or 1000000, not '0'"},
    {"MemoryNegative", "reconstruct in.xyz -o out.ply --memory-limit -1G", 2,
     "--memory-limit: must be a size such as 4G, 512M or 1000000, not '-1G'"},
    {"QuietAndVerbose", "reconstruct in.xyz -o out.ply --quiet --verbose", 2,
     "--quiet excludes --verbose"},
    {"CheckWithoutMesh", "check", 2, "mesh is required"},
    {"InfoWithoutFile", "info", 2, "file is required"},
    {"HelpOnNothing", "help rebuild", 2, "there is no command 'rebuild'"},
    {"OutputIsInput", "reconstruct in.ply -o in.ply", 2,
     "'in.ply': the mesh would overwrite the input"},
    {"OutputIsInputByAnotherName", "reconstruct in.ply -o ./../$(basename $PWD)/in.ply", 2, "..."},
    {"TwoOutputsInOne", "reconstruct in.xyz -o out.ply --report out.ply", 2,
     "'out.ply': the mesh and the report would both be written to it"},
    {"FeaturesInTheMesh", "reconstruct in.xyz -o out.ply --features out.ply", 2,
     "'out.ply': the mesh and the network of curves would both be written to it"},
    {"FeaturesWithoutName", "reconstruct in.xyz -o out.ply --features ''", 2,
     "--features: must name a file"},
    {"TrimWithValue", "reconstruct in.xyz -o out.ply --trim=maybe", 2, "..."},
};

class BadOption : public testing::TestWithParam<Refusal> {};

TEST_P(BadOption, IsRefused) {
  const Workplace place;
  place.write("in.xyz", sphere_xyz(20));
  place.write("in.ply", "not looked at");
  expect_refused(place, "", GetParam());
  EXPECT_EQ(place.read("in.ply"), "not looked at");
}

INSTANTIATE_TEST_SUITE_P(Table, BadOption, testing::ValuesIn(rows), name_of);

}  // namespace
}  // namespace arris::test
