// What the fuzz targets share: bytes into a reader, and what must hold of all that comes out.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <functional>

#include "base/failure.h"
#include "io/readers.h"

namespace arris::fuzz {

inline void require(bool condition) {
  if (!condition) std::abort();
}

// Every attribute has a value for every vertex, every triangle names vertices that are there, and
// no file makes more of itself than a small multiple of its bytes.
inline void require_sound(const Shape& shape, std::size_t bytes) {
  for (const Attribute& a : shape.attributes) require(a.values.size() == shape.positions.size());
  for (const Triangle& t : shape.triangles)
    for (const Index v : t) require(v < shape.positions.size());
  require(shape.positions.size() <= bytes && shape.triangles.size() <= bytes);
}

// Reads the bytes. A failure must be one of the documented kinds.
inline void read(const std::uint8_t* data, std::size_t size,
                 const std::function<Shape(const Source&)>& reader) {
  Context context;
  context.memory_limit = std::size_t{1} << 28;
  Job job(context);
  job.stage("parse", 1);
  try {
    require_sound(reader({"fuzz", {reinterpret_cast<const char*>(data), size}, job}), size);
  } catch (const Failure& failure) {
    const ErrorCode code = failure.error().code;
    require(code == ErrorCode::unreadable || code == ErrorCode::unsupported ||
            code == ErrorCode::out_of_memory);
    require(!failure.error().message.empty() && !failure.error().remedy.empty());
  }
}

}  // namespace arris::fuzz
