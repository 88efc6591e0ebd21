// PNG, by libpng.
#pragma once

#include <string>

#include "viewer/image.h"

namespace arris::viewer {

// The bytes of a PNG file: 8 bits a channel, sRGB, no time stamp; the same for the same image and
// version of libpng and zlib. Throws std::runtime_error if libpng refuses (an empty image).
std::string encode_png(const Image& image);

}  // namespace arris::viewer
