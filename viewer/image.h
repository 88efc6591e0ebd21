// A picture in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace arris::viewer {

// Colours are sRGB, 0 to 1, wherever they are not light.
struct Colour {
  double red = 1, green = 1, blue = 1;
};

// Rows from top to bottom, three bytes a pixel (sRGB).
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  Image() = default;
  // White.
  Image(int w, int h)
      : width(w),
        height(h),
        rgb(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h), 255) {}
  std::uint8_t* at(int x, int y) {
    return &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x))];
  }
};

}  // namespace arris::viewer
