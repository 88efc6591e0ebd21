#include "viewer/png.h"

#include <png.h>

#include <stdexcept>

namespace arris::viewer {

std::string encode_png(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;

  // The first call measures, the second writes.
  png_alloc_size_t size = 0;
  const auto write = [&](void* memory) {
    if (!png_image_write_to_memory(&header, memory, &size, 0, image.rgb.data(), 0, nullptr))
      throw std::runtime_error(std::string("cannot make a PNG: ") + header.message);
  };
  write(nullptr);
  std::string bytes(size, '\0');
  write(bytes.data());
  bytes.resize(size);
  return bytes;
}

}  // namespace arris::viewer
