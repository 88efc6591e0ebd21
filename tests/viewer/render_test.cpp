#include "viewer/render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>

#include "support/samplers.h"
#include "support/shapes.h"
#include "viewer/legend.h"
#include "viewer/png.h"

namespace arris::viewer {
namespace {

View small_view() {
  View view;
  view.width = 160;
  view.height = 120;
  view.quality.supersampling = 2;
  view.quality.occlusion = 8;
  return view;
}

Image rendered(const std::vector<Panel>& panels, const View& view) {
  const Result<Image> image = render(panels, view);
  EXPECT_TRUE(image) << image.error().message;
  return image ? *image : Image(1, 1);
}

Image rendered(const Mesh& mesh, const View& view) {
  return rendered({{mesh, {}, ""}}, view);
}

struct Rgb {
  int red, green, blue;
};

int count(const Image& image, const std::function<bool(Rgb)>& is) {
  int n = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3)
    n += is({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
  return n;
}

bool is_white(Rgb c) {
  return c.red == 255 && c.green == 255 && c.blue == 255;
}
bool is_dark(Rgb c) {
  return c.red < 60 && c.green < 60 && c.blue < 60;
}
bool is_red(Rgb c) {
  return c.red > 180 && c.green < 90 && c.blue < 90;
}
bool is_ochre(Rgb c) {
  return c.red > c.blue + 40 && c.green > c.blue + 20;
}
bool is_blue(Rgb c) {
  return c.blue > c.red + 30;
}

TEST(Render, ACubeOnWhitePaper) {
  const View view = small_view();
  Image image = rendered(test::cube().mesh, view);
  ASSERT_EQ(image.width, 160);
  ASSERT_EQ(image.height, 120);
  ASSERT_EQ(image.rgb.size(), 160u * 120 * 3);
  for (const int x : {0, 159})
    for (const int y : {0, 119}) EXPECT_EQ(*image.at(x, y), 255);
  // A cube is about two thirds of its square, 0.9 of the height.
  const int shown = 160 * 120 - count(image, is_white);
  EXPECT_GT(shown, 6000);
  EXPECT_LT(shown, 12000);
  EXPECT_GT(count(image, is_dark), 400) << "nine edges, about 50 pixels each";
  EXPECT_EQ(count(image, is_red), 0);
  EXPECT_EQ(count(image, is_ochre), 0);
}

TEST(Render, FacesDifferInLight) {
  Image image = rendered(test::cube().mesh, small_view());
  const int top = *image.at(78, 22), left = *image.at(55, 70), right = *image.at(100, 70);
  EXPECT_GT(top, left + 15);
  EXPECT_GT(left, right + 15);
}

TEST(Render, TheSameBytesWhateverTheThreads) {
  const std::vector<Panel> panels = {{test::perforated_cube().mesh, {}, "cube"}};
  Context context;
  context.threads = 1;
  const Result<Image> one = render(panels, small_view(), context);
  context.threads = 3;
  const Result<Image> three = render(panels, small_view(), context);
  ASSERT_TRUE(one && three);
  EXPECT_EQ(encode_png(*one), encode_png(*three));
}

TEST(Render, CanBeStoppedAndTellsHowFarItIs) {
  const std::vector<Panel> panels(2, {test::cube().mesh, {}, ""});
  std::atomic<bool> cancel = false;
  Context context;
  context.cancel = &cancel;
  std::vector<double> told;
  context.progress = [&](std::string_view, double fraction) { told.push_back(fraction); };
  EXPECT_TRUE(render(panels, small_view(), context));
  EXPECT_EQ(told, (std::vector<double>{0.5, 1}));
  context.progress = [&](std::string_view, double) { cancel = true; };
  const Result<Image> stopped = render(panels, small_view(), context);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}

TEST(Render, PlaceAndUnitDoNotMatter) {
  const Mesh mesh = test::two_cubes().mesh;
  Mesh far = mesh;
  for (Vec3& p : far.vertices) p = {4 * p.x + 0x1p30, 4 * p.y, 4 * p.z - 0x1p20};
  EXPECT_EQ(rendered(far, small_view()).rgb, rendered(mesh, small_view()).rgb);
}

TEST(Render, AnEdgeAngleOf180LeavesOnlyTheContour) {
  View view = small_view();
  Image with = rendered(test::cube().mesh, view);
  view.edge_angle = 180;
  Image without = rendered(test::cube().mesh, view);
  const auto darkest_on_row = [](Image& image, int y) {
    int darkest = 255;
    for (int x = 70; x < 110; ++x) darkest = std::min(darkest, int{*image.at(x, y)});
    return darkest;
  };
  EXPECT_LT(darkest_on_row(with, 70), 60) << "the edge between the two front faces";
  EXPECT_GT(darkest_on_row(without, 70), 90);
  EXPECT_GT(count(without, is_dark), 50);
}

TEST(Render, WireframeAddsTheOtherEdges) {
  View view = small_view();
  const Image plain = rendered(test::cube().mesh, view);
  view.wireframe = true;
  EXPECT_NE(rendered(test::cube().mesh, view).rgb, plain.rgb);
}

TEST(Render, HolesAreRedAndBacksOchre) {
  Mesh open = test::cube().mesh;
  std::erase_if(open.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](Index v) { return open.vertices[v].z == 1; });
  });
  ASSERT_EQ(open.triangles.size(), 10u);
  const Image image = rendered(open, small_view());
  EXPECT_GT(count(image, is_red), 100);
  EXPECT_GT(count(image, is_ochre), 500);
}

TEST(Render, PointsAreBlueBalls) {
  View view = small_view();
  const std::vector<Vec3> points = test::sample_blue(test::cube().mesh, 60, 1);
  const int small = count(rendered({{{}, points, ""}}, view), is_blue);
  EXPECT_GT(small, 100);
  view.point_size = 8;
  EXPECT_GT(count(rendered({{{}, points, ""}}, view), is_blue), 2 * small);
  EXPECT_EQ(count(rendered(test::cube().mesh, view), is_blue), 0);
}

TEST(Render, HollowsAreDarker) {
  View view = small_view();
  const auto brightness = [&](int occlusion) {
    view.quality.occlusion = occlusion;
    const Image image = rendered(test::perforated_cube().mesh, view);
    long sum = 0;
    for (const std::uint8_t c : image.rgb) sum += c;
    return sum;
  };
  EXPECT_LT(brightness(32), brightness(0));
}

TEST(Render, PanelsStandInRowsWithCaptions) {
  View view = small_view();
  const Panel cube = {test::cube().mesh, {}, "cube"}, plain = {test::cube().mesh, {}, ""};
  Image row = rendered({cube, plain, plain}, view);
  EXPECT_EQ(row.width, 480);
  EXPECT_GT(row.height, 120);
  view.columns = 2;
  Image grid = rendered({cube, plain, plain}, view);
  EXPECT_EQ(grid.width, 320);
  EXPECT_EQ(grid.height, 2 * row.height);
  // The same cube in every panel, a caption under the first alone.
  const auto dark_in = [](Image& image, int x0, int y0, int y1) {
    int n = 0;
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x0 + 160; ++x) n += *image.at(x, y) < 100;
    return n;
  };
  EXPECT_EQ(dark_in(row, 0, 0, 120), dark_in(row, 320, 0, 120));
  EXPECT_GT(dark_in(row, 0, 120, row.height), 20);
  EXPECT_EQ(dark_in(row, 160, 120, row.height), 0);
}

TEST(Render, ACommonFrameKeepsSizesComparable) {
  View view = small_view();
  Mesh half = test::cube().mesh;
  for (Vec3& p : half.vertices) p = {p.x / 2, p.y / 2, p.z / 2};
  const auto right_half = [&] {
    Image image = rendered({{test::cube().mesh, {}, ""}, {half, {}, ""}}, view);
    int n = 0;
    for (int y = 0; y < 120; ++y)
      for (int x = 160; x < 320; ++x) n += *image.at(x, y) != 255;
    return n;
  };
  const int own = right_half();
  view.common_frame = true;
  EXPECT_NEAR(right_half(), own / 4.0, own / 12.0);
}

TEST(Render, AnyAxisMayPointUp) {
  View view = small_view();
  const Image upright = rendered(test::wedge().mesh, view);
  Mesh y_up = test::wedge().mesh, x_up = y_up;
  for (Vec3& p : y_up.vertices) p = {p.x, p.z, -p.y};
  for (Vec3& p : x_up.vertices) p = {p.z, p.x, p.y};
  view.up = Up::y;
  EXPECT_EQ(rendered(y_up, view).rgb, upright.rgb);
  view.up = Up::x;
  EXPECT_EQ(rendered(x_up, view).rgb, upright.rgb);
}

TEST(Render, OddInputsAreDrawnOrRefused) {
  const View view = small_view();
  const Mesh cube = test::cube().mesh;
  const auto code = [&](const std::vector<Panel>& panels, const View& v) {
    const Result<Image> image = render(panels, v);
    return image ? 0 : static_cast<int>(image.error().code);
  };
  EXPECT_EQ(code({{{}, {{1, 2, 3}}, ""}}, view), 0) << "a single point";
  EXPECT_EQ(code({{Mesh{{{0, 0, 0}, {1, 1, 1}}, {{0, 1, 1}}, {}, {}, {}}, {}, ""}}, view), 0)
      << "a degenerate triangle";
  EXPECT_EQ(code({{{}, {{0, 0, 0}, {1e-310, 0, 0}, {0, 1e-310, 0}}, ""}}, view), 0) << "tiny";
  EXPECT_EQ(code({{{}, {{0, 0, 0}, {1e149, 0, 0}, {0, -1e149, 0}}, ""}}, view), 0) << "huge";
  EXPECT_EQ(code({}, view), static_cast<int>(ErrorCode::usage));
  EXPECT_EQ(code({{}}, view), static_cast<int>(ErrorCode::bad_points));
  Mesh broken = cube;
  broken.triangles[0][0] = 8;
  EXPECT_EQ(code({{broken, {}, ""}}, view), static_cast<int>(ErrorCode::unreadable));
  Mesh infinite = cube;
  infinite.vertices[0].x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(code({{infinite, {}, ""}}, view), static_cast<int>(ErrorCode::bad_points));
  EXPECT_EQ(code({{{}, {{1e200, 0, 0}}, ""}}, view), static_cast<int>(ErrorCode::bad_points));
  for (const auto& spoil : std::vector<std::function<void(View&)>>{
           [](View& v) { v.width = 0; }, [](View& v) { v.height = 1 << 20; },
           [](View& v) { v.elevation = 91; }, [](View& v) { v.zoom = 0; },
           [](View& v) { v.edge_angle = std::numeric_limits<double>::quiet_NaN(); },
           [](View& v) { v.columns = -1; }, [](View& v) { v.quality.supersampling = 0; },
           [](View& v) { v.width = v.height = 16384, v.columns = 1; }}) {
    View spoiled = view;
    spoil(spoiled);
    const std::vector<Panel> two = {{cube, {}, ""}, {cube, {}, ""}};
    EXPECT_EQ(code(two, spoiled), static_cast<int>(ErrorCode::usage));
  }
}

// The paint is asked for positions of the model's own, whichever axis is up: green above is above.
TEST(Render, PaintColoursPositionsOfTheModel) {
  const auto is_green = [](Rgb c) { return c.green > c.red + 60 && c.green > c.blue + 60; };
  const auto is_any_red = [](Rgb c) { return c.red > c.green + 60 && c.red > c.blue + 60; };
  Mesh mesh = test::cube().mesh;
  for (Vec3& p : mesh.vertices) p = {p.x + 2, p.y - 3, p.z + 1};
  for (const Up up : {Up::x, Up::y, Up::z}) {
    View view = small_view();
    view.up = up;
    view.elevation = 0;
    const auto green_above = [up](Vec3 p) {
      const double height = up == Up::x ? p.x - 2 : up == Up::y ? p.y + 3 : p.z - 1;
      return height > 0.5 ? Colour{0, 1, 0} : Colour{1, 0, 0};
    };
    Image image = rendered({{mesh, {}, "", green_above}}, view);
    EXPECT_GT(count(image, is_green), 1000);
    EXPECT_GT(count(image, is_any_red), 1000);
    image.rgb.resize(image.rgb.size() / 2 - 3 * 160);  // the upper half
    EXPECT_EQ(count(image, is_any_red), 0);
  }
}

TEST(Legend, IsABarBelowThePicture) {
  const Image picture(200, 100);
  const Image image = with_legend(picture, {[](double t) {
                                              return Colour{t, 0, 0};
                                            },
                                            "0", "1", ""});
  EXPECT_EQ(image.width, 200);
  EXPECT_GT(image.height, 100);
  const auto is_ink_free_black = [](Rgb c) { return c.red < 40 && c.green == 0 && c.blue == 0; };
  const auto is_full_red = [](Rgb c) { return c.red > 215 && c.green == 0 && c.blue == 0; };
  EXPECT_GT(count(image, is_ink_free_black), 20);
  EXPECT_GT(count(image, is_full_red), 20);
  EXPECT_EQ(std::vector<std::uint8_t>(image.rgb.begin(), image.rgb.begin() + 60000), picture.rgb);
}

}  // namespace
}  // namespace arris::viewer
