// Curves, patches, fills and trimming through the command.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "cli/workplace.h"

namespace arris::test {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// The surface of the cube [0, n]^3, sampled on the integer grid, edges and corners too.
std::string cube_xyz(int n) {
  std::ostringstream text;
  for (int x = 0; x <= n; ++x)
    for (int y = 0; y <= n; ++y)
      for (int z = 0; z <= n; ++z)
        if (x == 0 || x == n || y == 0 || y == n || z == 0 || z == n)
          text << x << ' ' << y << ' ' << z << '\n';
  return text.str();
}

// The lines of a spiral on the sphere that lie below this height.
std::string below(double height) {
  std::istringstream all(sphere_xyz(3000));
  std::string kept, line;
  while (std::getline(all, line))
    if (std::stod(line.substr(line.rfind(' '))) < height) kept += line + "\n";
  return kept;
}

TEST(Features, ACubeHasTwelveCurves) {
  const Workplace place;
  place.write("in.xyz", cube_xyz(12));
  const Outcome outcome =
      place.arris("reconstruct in.xyz -o out.obj --features c.obj --report r.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "12 curves, 8 corners, 6 patches")) << outcome.out;
  EXPECT_TRUE(contains(place.read("c.obj"), "g curve_11 convex\nl "));
  EXPECT_FALSE(contains(place.read("c.obj"), "g curve_12"));
  EXPECT_TRUE(contains(place.read("out.obj"), "g patch_5\n"));
  EXPECT_TRUE(contains(place.read("r.json"), "\"convex_curves\": 12"));
  EXPECT_TRUE(contains(place.read("r.json"), "\"filled_faces\": 0"));
  EXPECT_EQ(place.entries(), (std::set<std::string>{"in.xyz", "out.obj", "c.obj", "r.json"}));
  const Outcome info = place.arris("info out.obj");
  EXPECT_TRUE(contains(info.out, "features    12 curves, 8 corners, 6 patches")) << info.out;
}

TEST(Features, FacesSayWhetherSamplesSupportThem) {
  const Workplace place;
  place.write("in.xyz", below(0.8));
  ASSERT_EQ(place.arris("reconstruct in.xyz -o out.ply --quiet").exit_code, 0);
  const std::string mesh = place.read("out.ply");
  EXPECT_TRUE(
      contains(mesh, "property float support\nproperty uchar filled\nproperty int patch\n"));
  const Outcome info = place.arris("info out.ply");
  EXPECT_TRUE(contains(info.out, "filled, uint8, 0 .. 1")) << info.out;
}

TEST(Trim, LeavesAnOpenMeshThatIsSound) {
  const Workplace place;
  place.write("in.xyz", below(0.8));
  const Outcome outcome =
      place.arris("reconstruct in.xyz -o out.ply --trim --report r.json --features c.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "open, manifold, oriented")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "Euler characteristic 1\n")) << outcome.out;  // a disc
  EXPECT_TRUE(contains(place.read("r.json"), "\"trimmed\": true"));
  EXPECT_TRUE(contains(place.read("r.json"), "\"sound\": true"));
  EXPECT_TRUE(contains(place.read("r.json"), "\"closed\": false"));
  EXPECT_EQ(place.arris("check out.ply --quiet").exit_code, 8);
  EXPECT_EQ(place.arris("check out.ply --quiet --open").exit_code, 0);
  const Outcome check = place.arris("check out.ply --open");
  EXPECT_TRUE(contains(check.out, "open, sound otherwise")) << check.out;
}

TEST(Trim, LeavesAMeshWithoutFillsAsItIs) {
  const Workplace place;
  place.write("in.xyz", sphere_xyz(500));
  ASSERT_EQ(place.arris("reconstruct in.xyz -o whole.ply --quiet").exit_code, 0);
  ASSERT_EQ(place.arris("reconstruct in.xyz -o trimmed.ply --quiet --trim").exit_code, 0);
  EXPECT_TRUE(place.read("whole.ply") == place.read("trimmed.ply"));
  EXPECT_EQ(place.arris("check trimmed.ply --quiet").exit_code, 0);
}

TEST(Trim, CheckOpenStillRefusesDefects) {
  const Workplace place;
  place.write("m.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n");
  EXPECT_EQ(place.arris("check m.off --quiet --open").exit_code, 8);  // they touch in a vertex
}

}  // namespace
}  // namespace arris::test
