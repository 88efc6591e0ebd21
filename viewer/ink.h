// Anti-aliased strokes of round pens, on a picture or a part of one.
#pragma once

#include <cstddef>
#include <vector>

#include "viewer/geometry.h"
#include "viewer/image.h"

namespace arris::viewer {

// How much of every pixel is covered by one colour of ink. Strokes that overlap do not add up, so
// that a line drawn in pieces looks as if drawn at once.
class Ink {
 public:
  Ink(int width, int height);

  // A stroke from a to b, `pen` pixels wide; a dot if a == b. What lies outside is left out.
  void stroke(Pixel a, Pixel b, double pen);

  // Does a pen held at `at` touch the paper?
  bool touches(Pixel at, double pen) const {
    const double reach = pen / 2 + 0.5;
    return at.x > -reach && at.y > -reach && at.x < width_ + reach && at.y < height_ + reach;
  }

  // Lays the ink over the part of the image whose upper left corner is (x, y).
  void lay(Image& image, int x, int y, Colour colour) const;

 private:
  int width_, height_;
  std::vector<float> cover_;  // 0 to 1, row by row
};

}  // namespace arris::viewer
