#include "viewer/legend.h"

#include <algorithm>
#include <cmath>

#include "viewer/lettering.h"

namespace arris::viewer {
namespace {

constexpr Colour ink_colour = {0.08, 0.09, 0.12};
constexpr double letter_unit = 1.6, letter_pen = 1.5;                    // pixels
constexpr int strip_height = 32, bar_height = 12, margin = 12, gap = 8;  // pixels
constexpr double bar_share = 0.3;  // of the width of the picture

std::uint8_t byte(double x) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0, 1.0)));
}

int width_of(const std::string& text) {
  return static_cast<int>(std::ceil(text_width(text, letter_unit)));
}

}  // namespace

Image with_legend(const Image& image, const Legend& legend) {
  Image result(image.width, image.height + strip_height);
  std::copy(image.rgb.begin(), image.rgb.end(), result.rgb.begin());
  const int left = margin + width_of(legend.low) + gap;
  const int bar = static_cast<int>(bar_share * image.width);
  const int right = std::min(left + bar, image.width);
  const int top = image.height + (strip_height - bar_height) / 2;
  for (int x = left; x < right; ++x) {
    const Colour c = legend.colour((x - left + 0.5) / bar);
    for (int y = top; y < top + bar_height; ++y) {
      std::uint8_t* pixel = result.at(x, y);
      pixel[0] = byte(c.red), pixel[1] = byte(c.green), pixel[2] = byte(c.blue);
    }
  }
  Ink ink(image.width, strip_height);
  const double base = strip_height / 2.0 + 3 * letter_unit;  // capitals are six units high
  draw_text(ink, legend.low, {margin, base}, letter_unit, letter_pen);
  const double after = left + bar + gap;
  draw_text(ink, legend.high + "   " + legend.title, {after, base}, letter_unit, letter_pen);
  ink.lay(result, 0, image.height, ink_colour);
  return result;
}

}  // namespace arris::viewer
