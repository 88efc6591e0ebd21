// What the command says when all is well.
#include <gtest/gtest.h>

#include <string>

#include "arris/version.h"
#include "cli/workplace.h"

namespace arris::test {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Talk, WithoutArgumentsPrintsThreeExamples) {
  const Workplace place;
  const Outcome outcome = place.arris("");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  int examples = 0;
  for (std::size_t at = 0; (at = outcome.out.find("\n  arris ", at)) != std::string::npos; ++at)
    ++examples;
  EXPECT_EQ(examples, 3);
}

TEST(Talk, Version) {
  const Workplace place;
  EXPECT_EQ(place.arris("--version").out, "arris " ARRIS_VERSION "\n");
}

TEST(Talk, HelpNamesCommandsOptionsAndExitCodes) {
  const Workplace place;
  const Outcome all = place.arris("help");
  EXPECT_EQ(all.exit_code, 0);
  for (const char* part :
       {"reconstruct", "check", "info", "help", "--version", "  130  interrupted"})
    EXPECT_TRUE(contains(all.out, part)) << part;
  EXPECT_EQ(place.arris("--help").out, all.out);
  const Outcome one = place.arris("help reconstruct");
  for (const char* part :
       {"--output",       "--method",          "--lambda",   "--noise",        "--cycles",
        "--background",   "--curvature",       "--no-swap",  "--free-samples", "--no-sharpen",
        "--refine",       "--outliers",        "--tets",     "--report",       "--threads",
        "--memory-limit", "--drop-non-finite", "--features", "--trim",         "--quiet",
        "--verbose"})
    EXPECT_TRUE(contains(one.out, part)) << part;
  EXPECT_EQ(place.arris("reconstruct --help").out, one.out);
}

TEST(Talk, ReconstructSaysWhatItDid) {
  const Workplace place;
  place.write("in.xyz", sphere_xyz(300));
  const Outcome outcome =
      place.arris("reconstruct in.xyz -o out.ply --report r.json --tets t.vtk --verbose");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out,
                       "out.ply: 300 vertices, 596 faces, 1 component, Euler "
                       "characteristic 2\n"))
      << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "closed, manifold, oriented")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "stages\n")) << outcome.out;
  EXPECT_FALSE(contains(outcome.err, "\x1b")) << "control codes without a terminal";
  EXPECT_EQ(place.entries(), (std::set<std::string>{"in.xyz", "out.ply", "r.json", "t.vtk"}));
}

TEST(Talk, QuietSaysNothing) {
  const Workplace place;
  place.write("in.xyz", sphere_xyz(300));
  const Outcome outcome = place.arris("reconstruct in.xyz -o out.ply --quiet");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST(Talk, ThreadsDoNotChangeTheMesh) {
  const Workplace place;
  place.write("in.xyz", sphere_xyz(3000));
  for (const char* threads : {"1", "2"})
    ASSERT_EQ(place
                  .arris(std::string("reconstruct in.xyz --quiet --threads ") + threads + " -o " +
                         threads + ".ply")
                  .exit_code,
              0);
  EXPECT_TRUE(place.read("1.ply") == place.read("2.ply"));
}

TEST(Talk, InfoDescribesPoints) {
  const Workplace place;
  place.write("in.csv", "x,y,z,red\n0,0,0,7\n1,2,3,9\n0,0,0,8\n");
  const Outcome outcome = place.arris("info in.csv");
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* part : {"in.csv: 3 points", "0 0 0 .. 1 2 3", "duplicates  1", "red"})
    EXPECT_TRUE(contains(outcome.out, part)) << outcome.out;
}

TEST(Talk, InfoDescribesMeshes) {
  const Workplace place;
  place.write("m.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  const Outcome outcome = place.arris("info m.off");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(contains(outcome.out, "m.off: 4 points")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "triangles   2")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "features    0 curves, 0 corners, 1 patch")) << outcome.out;
}

}  // namespace
}  // namespace arris::test
