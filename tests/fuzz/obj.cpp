#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace arris;
  fuzz::read(data, size, [](const Source& s) { return read_obj(s, Want::mesh); });
  fuzz::read(data, size, [](const Source& s) { return read_obj(s, Want::points); });
  return 0;
}
