#include "viewer/ink.h"

#include <algorithm>
#include <cmath>

namespace arris::viewer {
namespace {

double distance_to_segment(Pixel p, Pixel a, Pixel b) {
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
  const double t = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

int clamped(double value, int limit) {
  return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(limit)));
}

std::uint8_t blend(std::uint8_t below, double above, double cover) {
  const double mixed = static_cast<double>(below) * (1 - cover) + 255 * above * cover;
  return static_cast<std::uint8_t>(std::lround(std::clamp(mixed, 0.0, 255.0)));
}

}  // namespace

Ink::Ink(int width, int height)
    : width_(width),
      height_(height),
      cover_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0f) {}

void Ink::stroke(Pixel a, Pixel b, double pen) {
  const double reach = pen / 2 + 0.5;  // a pixel is half covered where the rim passes its middle
  // Rows, and in each row only the columns that the stroke may touch: long diagonal strokes would
  // otherwise cost their whole bounding box.
  const int top = clamped(std::floor(std::min(a.y, b.y) - reach), height_);
  const int bottom = clamped(std::ceil(std::max(a.y, b.y) + reach), height_);
  for (int y = top; y < bottom; ++y) {
    const double yc = y + 0.5;
    double x0 = std::min(a.x, b.x), x1 = std::max(a.x, b.x);
    if (std::abs(b.y - a.y) > 1e-9) {
      const auto x_at = [&](double row) {
        return a.x + std::clamp((row - a.y) / (b.y - a.y), 0.0, 1.0) * (b.x - a.x);
      };
      const double p = x_at(yc - reach), q = x_at(yc + reach);
      x0 = std::min(p, q), x1 = std::max(p, q);
    }
    const int left = clamped(std::floor(x0 - reach), width_);
    const int right = clamped(std::ceil(x1 + reach), width_);
    for (int x = left; x < right; ++x) {
      const double cover = std::min(1.0, reach - distance_to_segment({x + 0.5, yc}, a, b));
      float& here = cover_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                           static_cast<std::size_t>(x)];
      here = std::max(here, static_cast<float>(cover));
    }
  }
}

void Ink::lay(Image& image, int x, int y, Colour colour) const {
  std::size_t i = 0;
  for (int row = 0; row < height_; ++row)
    for (int column = 0; column < width_; ++column, ++i) {
      if (cover_[i] <= 0) continue;
      std::uint8_t* pixel = image.at(x + column, y + row);
      const double cover = static_cast<double>(cover_[i]);
      pixel[0] = blend(pixel[0], colour.red, cover);
      pixel[1] = blend(pixel[1], colour.green, cover);
      pixel[2] = blend(pixel[2], colour.blue, cover);
    }
}

}  // namespace arris::viewer
