// The table of command lines that are refused, all with exit code 2 and before any file is touched.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "cli/workplace.h"

namespace arris::test {
namespace {

struct Row {
  const char* name;
  const char* arguments;
  const char* message;
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.name;
}

const Row rows[] = {
    {"UnknownCommand", "rebuild in.xyz", "the following arguments were not expected: ..."},
    {"NoInput", "reconstruct -o out.ply", "input is required"},
    {"NoOutput", "reconstruct in.xyz", "--output is required"},
    {"OutputWithoutName", "reconstruct in.xyz -o", "--output: 1 required file missing"},
    {"EmptyOutput", "reconstruct in.xyz -o ''", "--output: must name a file"},
    {"EmptyInput", "reconstruct '' -o out.ply", "input: must name a file"},
    {"TwoInputs", "reconstruct in.xyz more.xyz -o out.ply",
     "the following argument was not expected: more.xyz"},
    {"UnknownOption", "reconstruct in.xyz -o out.ply --sharp",
     "the following argument was not expected: --sharp"},
    {"UnknownMethod", "reconstruct in.xyz -o out.ply --method magic",
     "--method: must be one of default|paper, not 'magic'"},
    {"UnknownCurvature", "reconstruct in.xyz -o out.ply --curvature gauss",
     "--curvature: must be one of area|cotangent|polyhedral, not 'gauss'"},
    {"LambdaNegative", "reconstruct in.xyz -o out.ply --lambda -1",
     "--lambda: must be a number from 0 to 1000000, not '-1'"},
    {"LambdaNan", "reconstruct in.xyz -o out.ply --lambda nan",
     "--lambda: must be a number from 0 to 1000000, not 'nan'"},
    {"LambdaInfinite", "reconstruct in.xyz -o out.ply --lambda inf",
     "--lambda: must be a number from 0 to 1000000, not 'inf'"},
    {"NoiseNegative", "reconstruct in.xyz -o out.ply --noise -1",
     "--noise: must be a number from 0, not '-1'"},
    {"LambdaWord", "reconstruct in.xyz -o out.ply --lambda much",
     "--lambda: must be a number from 0 to 1000000, not 'much'"},
    {"CyclesZero", "reconstruct in.xyz -o out.ply --cycles 0",
     "--cycles: must be a whole number from 1 to 100, not '0'"},
    {"CyclesNegative", "reconstruct in.xyz -o out.ply --cycles -1",
     "--cycles: must be a whole number from 1 to 100, not '-1'"},
    {"CyclesHuge", "reconstruct in.xyz -o out.ply --cycles 99999999999999999999",
     "--cycles: must be a whole number from 1 to 100, not '99999999999999999999'"},
    {"CyclesBroken", "reconstruct in.xyz -o out.ply --cycles 2.5",
     "--cycles: must be a whole number from 1 to 100, not '2.5'"},
    {"BackgroundNegative", "reconstruct in.xyz -o out.ply --background -3",
     "--background: must be a number from 0 to 1000, not '-3'"},
    {"BackgroundHuge", "reconstruct in.xyz -o out.ply --background 1e9",
     "--background: must be a number from 0 to 1000, not '1e9'"},
    {"ThreadsNegative", "reconstruct in.xyz -o out.ply --threads -2",
     "--threads: must be a whole number from 0 to 256, not '-2'"},
    {"ThreadsHuge", "reconstruct in.xyz -o out.ply --threads 100000",
     "--threads: must be a whole number from 0 to 256, not '100000'"},
    {"MemoryWord", "reconstruct in.xyz -o out.ply --memory-limit lots",
     "--memory-limit: must be a size such as 4G, 512M or 1000000, not 'lots'"},
    {"MemoryUnit", "reconstruct in.xyz -o out.ply --memory-limit 4X",
     "--memory-limit: must be a size such as 4G, 512M or 1000000, not '4X'"},
    {"MemoryZero", "reconstruct in.xyz -o out.ply --memory-limit 0",
     "--memory-limit: must be a size such as 4G, 512M or 1000000, not '0'"},
    {"MemoryNegative", "reconstruct in.xyz -o out.ply --memory-limit -1G",
     "--memory-limit: must be a size such as 4G, 512M or 1000000, not '-1G'"},
    {"QuietAndVerbose", "reconstruct in.xyz -o out.ply --quiet --verbose",
     "--quiet excludes --verbose"},
    {"CheckWithoutMesh", "check", "mesh is required"},
    {"InfoWithoutFile", "info", "file is required"},
    {"HelpOnNothing", "help rebuild", "there is no command 'rebuild'"},
    {"OutputIsInput", "reconstruct in.ply -o in.ply",
     "'in.ply': the mesh would overwrite the input"},
    {"OutputIsInputByAnotherName", "reconstruct in.ply -o ./../$(basename $PWD)/in.ply", "..."},
    {"TwoOutputsInOne", "reconstruct in.xyz -o out.ply --report out.ply",
     "'out.ply': the mesh and the report would both be written to it"},
    {"FeaturesInTheMesh", "reconstruct in.xyz -o out.ply --features out.ply",
     "'out.ply': the mesh and the network of curves would both be written to it"},
    {"FeaturesWithoutName", "reconstruct in.xyz -o out.ply --features ''",
     "--features: must name a file"},
    {"TrimWithValue", "reconstruct in.xyz -o out.ply --trim=maybe", "..."},
};

class BadOption : public testing::TestWithParam<Row> {};

TEST_P(BadOption, IsRefused) {
  const Workplace place;
  const std::string points = sphere_xyz(20);
  place.write("in.xyz", points);
  place.write("in.ply", "not looked at");
  const Outcome outcome = place.arris(GetParam().arguments);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  const PrintedError error = printed_error(outcome.err);
  EXPECT_TRUE(matches(error.message, GetParam().message)) << outcome.err;
  EXPECT_NE(error.remedy, "") << outcome.err;
  EXPECT_EQ(place.entries(), (std::set<std::string>{"in.ply", "in.xyz"}));
  EXPECT_EQ(place.read("in.ply"), "not looked at");
}

INSTANTIATE_TEST_SUITE_P(Table, BadOption, testing::ValuesIn(rows),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace arris::test
