// The scale below a picture whose colours mean numbers.
#pragma once

#include <functional>
#include <string>

#include "viewer/image.h"

namespace arris::viewer {

// A bar of colours from colour(0) to colour(1).
struct Legend {
  std::function<Colour(double)> colour;
  std::string low, high;  // beside the ends of the bar; printable ASCII
  std::string title;      // after the label of the high end
};

// The image with a strip for the legend below it.
Image with_legend(const Image& image, const Legend& legend);

}  // namespace arris::viewer
