// Outputs that cannot be written: the exit code, the message, and that nothing is left behind.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "cli/workplace.h"

namespace arris::test {
namespace {

struct Row {
  const char* name;
  const char* before;  // shell text run first
  const char* outputs;
  int exit_code;
  const char* message;
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.name;
}

const Row rows[] = {
    {"UnknownExtension", "", "-o out.las", 4,
     "'out.las': the mesh is not written to files with the extension '.las'"},
    {"NoExtension", "", "-o out", 4,
     "'out': the mesh is not written to files with the extension ''"},
    {"UnknownVolumeExtension", "", "-o out.ply --tets out.tet", 4,
     "'out.tet': the volume is not written to files with the extension '.tet'"},
    {"UnknownFeaturesExtension", "", "-o out.ply --features curves.stl", 4,
     "'curves.stl': the network of curves is not written to files with the extension '.stl'"},
    {"NoSpaceForFeatures", "ln -s /dev/full f.json;", "-o out.ply --features f.json", 10,
     "'f.json': cannot be written: No space left on device"},
    {"ADirectory", "mkdir out.ply;", "-o out.ply", 10, "'out.ply': is a directory"},
    {"MissingDirectory", "", "-o no/out.ply", 10,
     "'no/out.ply': the directory 'no' does not exist"},
    {"FileAsDirectory", "echo > file;", "-o file/out.ply", 10,
     "'file/out.ply': 'file' is not a directory"},
    {"MissingReportDirectory", "", "-o out.ply --report no/report.json", 10,
     "'no/report.json': the directory 'no' does not exist"},
    {"NoSpaceOnDevice", "ln -s /dev/full out.ply;", "-o out.ply", 10,
     "'out.ply': cannot be written: No space left on device"},
    {"NoSpaceForReport", "ln -s /dev/full r.json;", "-o out.ply --report r.json", 10,
     "'r.json': cannot be written: No space left on device"},
    // The meshes below are larger than the 4 or 8 blocks that the limit leaves.
    {"FileSizeLimit", "ulimit -f 4;", "-o out.ply", 10,
     "'out.ply': cannot be written: File too large"},
    {"FileSizeLimitOnAsciiMesh", "ulimit -f 8;", "-o out.obj", 10,
     "'out.obj': cannot be written: File too large"},
    {"FileSizeLimitOnVolume", "ulimit -f 8;", "-o out.ply --tets out.msh", 10, "..."},
};

class BadOutput : public testing::TestWithParam<Row> {};

TEST_P(BadOutput, LeavesNothingBehind) {
  const Row& row = GetParam();
  const Workplace place;
  place.write("in.xyz", sphere_xyz(400));
  place.shell(std::string(row.before) + " true");
  const std::set<std::string> before = place.entries();
  const bool lasting = std::string(row.before).starts_with("ulimit");  // needed again by arris
  const Outcome outcome = place.arris("reconstruct in.xyz --quiet " + std::string(row.outputs),
                                      lasting ? row.before : "");
  EXPECT_EQ(outcome.exit_code, row.exit_code);
  const PrintedError error = printed_error(outcome.err);
  EXPECT_TRUE(matches(error.message, row.message)) << outcome.err;
  EXPECT_NE(error.remedy, "") << outcome.err;
  std::set<std::string> after = place.entries();
  // Outputs are written one after the other; a mesh that came before a failed report is whole.
  if (after.contains("out.ply") && !before.contains("out.ply")) {
    EXPECT_EQ(place.arris("check --quiet out.ply").exit_code, 0);
    after.erase("out.ply");
  }
  EXPECT_EQ(after, before);
}

INSTANTIATE_TEST_SUITE_P(Table, BadOutput, testing::ValuesIn(rows),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(BadOutput, AnOldMeshSurvivesAFailedWrite) {
  const Workplace place;
  place.write("in.xyz", sphere_xyz(400));
  place.write("out.ply", "precious");
  EXPECT_EQ(place.arris("reconstruct in.xyz -o out.ply", "ulimit -f 4;").exit_code, 10);
  EXPECT_EQ(place.read("out.ply"), "precious");
  EXPECT_EQ(place.entries(), (std::set<std::string>{"in.xyz", "out.ply"}));
}

TEST(BadOutput, ADirectoryClosedToWriting) {
  const Workplace place;
  place.write("in.xyz", sphere_xyz(20));
  if (place.shell("mkdir shut; chmod 555 shut; touch shut/file").exit_code == 0)
    GTEST_SKIP() << "this user may write everywhere";
  const Outcome outcome = place.arris("reconstruct in.xyz -o shut/out.ply --quiet");
  EXPECT_EQ(outcome.exit_code, 10);
  EXPECT_EQ(printed_error(outcome.err).message,
            "'shut/out.ply': the directory 'shut' cannot be written to: Permission denied");
}

TEST(BadOutput, AReadOnlyFile) {
  const Workplace place;
  place.write("in.xyz", sphere_xyz(20));
  if (place.shell("echo old > out.ply; chmod 444 out.ply; echo new >> out.ply").exit_code == 0)
    GTEST_SKIP() << "this user may write everywhere";
  const Outcome outcome = place.arris("reconstruct in.xyz -o out.ply --quiet");
  EXPECT_EQ(outcome.exit_code, 10);
  EXPECT_EQ(printed_error(outcome.err).message,
            "'out.ply': cannot be overwritten: Permission denied");
  EXPECT_EQ(place.read("out.ply"), "old\n");
}

}  // namespace
}  // namespace arris::test
