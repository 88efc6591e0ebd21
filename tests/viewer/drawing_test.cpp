// Ink, lettering, PNG: what is drawn in two dimensions.
#include <gtest/gtest.h>
#include <png.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "viewer/image.h"
#include "viewer/ink.h"
#include "viewer/lettering.h"
#include "viewer/png.h"

namespace arris::viewer {
namespace {

constexpr Colour black = {0, 0, 0};

// The image that ink leaves on white paper.
Image on_paper(const Ink& ink, int width, int height) {
  Image image(width, height);
  ink.lay(image, 0, 0, black);
  return image;
}

Image lettered(const std::string& text) {
  Ink ink(64, 32);
  draw_text(ink, text, {10, 20}, 2, 1.5);
  return on_paper(ink, 64, 32);
}

TEST(Ink, AStrokeIsAsWideAsItsPen) {
  Ink ink(20, 20);
  ink.stroke({2, 10}, {18, 10}, 4);
  const Image image = on_paper(ink, 20, 20);
  for (int y = 0; y < 20; ++y) {
    const int expected = y >= 8 && y < 12 ? 0 : 255;
    EXPECT_EQ(int{image.rgb[3 * (20 * static_cast<std::size_t>(y) + 10)]}, expected) << y;
  }
}

TEST(Ink, AHairlineBetweenPixelsIsGrey) {
  Ink ink(9, 9);
  ink.stroke({1, 4}, {8, 4}, 1);
  const Image image = on_paper(ink, 9, 9);
  EXPECT_NEAR(image.rgb[3 * (9 * 3 + 4)], 127.5, 1);
  EXPECT_EQ(image.rgb[3 * (9 * 3 + 4)], image.rgb[3 * (9 * 4 + 4)]);
}

TEST(Ink, PiecesOfAStrokeLookLikeTheWhole) {
  Ink whole(40, 40), pieces(40, 40);
  whole.stroke({3, 5}, {35, 29}, 2.5);
  for (int i = 0; i < 8; ++i)
    pieces.stroke({3 + i * 4.0, 5 + i * 3.0}, {7 + i * 4.0, 8 + i * 3.0}, 2.5);
  EXPECT_EQ(on_paper(whole, 40, 40).rgb, on_paper(pieces, 40, 40).rgb);
}

// The rows are narrowed to the columns that may be touched; the plain way must agree.
RC_GTEST_PROP(Ink, CoversWhatIsNear, ()) {
  const auto coordinate = rc::gen::map(rc::gen::inRange(-100, 300), [](int i) { return i / 10.0; });
  const Pixel a = {*coordinate, *coordinate}, b = {*coordinate, *coordinate};
  const double pen = *rc::gen::inRange(1, 60) / 10.0;
  Ink ink(20, 20);
  ink.stroke(a, b, pen);
  Image image = on_paper(ink, 20, 20);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) {
      double nearest = 1e9;  // to many points of the segment
      for (int i = 0; i <= 2000; ++i) {
        const double t = i / 2000.0;
        nearest = std::min(
            nearest, std::hypot(x + 0.5 - a.x - t * (b.x - a.x), y + 0.5 - a.y - t * (b.y - a.y)));
      }
      const double cover = std::clamp(pen / 2 + 0.5 - nearest, 0.0, 1.0);
      RC_ASSERT(std::abs(255 * (1 - cover) - *image.at(x, y)) < 2.5);
    }
}

TEST(Lettering, AllCharactersDifferAndStayInTheirLine) {
  std::set<std::string> seen;
  for (char c = ' '; c <= '~'; ++c) {
    if (c == 'O') continue;  // looks like the digit
    Image image = lettered(std::string(1, c));
    EXPECT_TRUE(seen.insert(encode_png(image)).second) << c;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 64; ++x) {
        // Units: 4 wide, 7 above the base line and 2 below; the pen adds a pixel and a half.
        const bool inside = x >= 8 && x < 20 && y >= 4 && y < 26;
        if (!inside) {
          EXPECT_EQ(*image.at(x, y), 255) << c;
        }
      }
  }
}

TEST(Lettering, WidthsAddUp) {
  EXPECT_EQ(text_width("", 2), 0);
  EXPECT_EQ(text_width("H", 2), 8);
  EXPECT_EQ(text_width("HH", 2), 2 * (4 + 2 + 4));
  EXPECT_EQ(text_width("H H", 1), 4 + 2 + 4 + 4);
}

TEST(Lettering, UnknownCharactersAreQuestionMarks) {
  EXPECT_EQ(lettered("\xC3").rgb, lettered("?").rgb);
  EXPECT_EQ(lettered("\n").rgb, lettered("?").rgb);
}

RC_GTEST_PROP(Png, ReadsBackAsWritten, ()) {
  Image image(*rc::gen::inRange(1, 20), *rc::gen::inRange(1, 20));
  for (std::uint8_t& c : image.rgb) c = *rc::gen::arbitrary<std::uint8_t>();
  const std::string bytes = encode_png(image);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  RC_ASSERT(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()));
  header.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(header));
  RC_ASSERT(png_image_finish_read(&header, nullptr, rgb.data(), 0, nullptr));
  RC_ASSERT(static_cast<int>(header.width) == image.width);
  RC_ASSERT(static_cast<int>(header.height) == image.height);
  RC_ASSERT(rgb == image.rgb);
}

TEST(Png, RefusesAnEmptyImage) {
  EXPECT_THROW(encode_png(Image()), std::runtime_error);
}

}  // namespace
}  // namespace arris::viewer
