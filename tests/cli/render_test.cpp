// arris render: what it accepts, refuses and writes. What pictures show is tested in tests/viewer.
#include <gtest/gtest.h>

#include <string>

#include "cli/refusal.h"

namespace arris::test {
namespace {

constexpr const char* tetrahedron =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

// Width and height of a PNG, as "WxH"; empty if it is none.
std::string png_size(const std::string& bytes) {
  if (bytes.size() < 24 || bytes.compare(1, 3, "PNG") != 0) return "";
  const auto number = [&](std::size_t at) {
    unsigned long value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
      value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return std::to_string(value);
  };
  return number(16) + "x" + number(20);
}

TEST(RenderCommand, FilesMayFollowCaptions) {
  const Workplace place;
  place.write("m.off", tetrahedron);
  place.write("p.xyz", sphere_xyz(50));
  const std::string options = "render --quiet --size 40x30 --samples 1 --occlusion 0 ";
  for (const char* arguments : {"--caption points p.xyz --caption mesh m.off -o picture.png",
                                "p.xyz m.off -o picture.png --caption points --caption mesh"}) {
    const Outcome outcome = place.arris(options + arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "");
  }
  const std::string size = png_size(place.read("picture.png"));
  EXPECT_EQ(size.substr(0, 3), "80x") << size;  // two panels, and captions below them
}

TEST(RenderCommand, PointsWithoutFacesAreDrawnWithAWarning) {
  const Workplace place;
  place.write("p.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 1\n");
  const Outcome outcome = place.arris("render p.off -o p.png --size 32x32");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("drawn as points"), std::string::npos) << outcome.err;
  EXPECT_EQ(png_size(place.read("p.png")), "32x32");
}

const Refusal rows[] = {
    {"NoFile", "-o p.png", 2, "files is required"},
    {"NoOutput", "m.off", 2, "--output is required"},
    {"NoPicture", "m.off -o p.jpg", 4, "..."},
    {"NoSuchFile", "none.off -o p.png", 3, "..."},
    {"Size", "m.off -o p.png --size 40", 2,
     "--size: must be WIDTHxHEIGHT, each a whole number from 16 to 16384, not '40'"},
    {"Up", "m.off -o p.png --up w", 2, "--up: must be one of x|y|z, not 'w'"},
    {"Zoom", "m.off -o p.png --zoom 0", 2, "--zoom: must be a number from 0.001 to 1000, not '0'"},
    {"Captions", "m.off -o p.png --caption a --caption b", 2, "there are more captions than files"},
    {"OverItself", "m.png -o m.png", 2, "'m.png': the picture would overwrite the input"},
};

class BadRender : public testing::TestWithParam<Refusal> {};

TEST_P(BadRender, IsRefused) {
  const Workplace place;
  place.write("m.off", tetrahedron);
  place.write("m.png", "not looked at");
  expect_refused(place, "render --quiet", GetParam());
}

INSTANTIATE_TEST_SUITE_P(Table, BadRender, testing::ValuesIn(rows), name_of);

}  // namespace
}  // namespace arris::test
