// The readers, one per format. Each parses bytes in memory, so that tests and fuzzers need no
// files.
#pragma once

#include <string>
#include <vector>

#include "arris/types.h"
#include "io/source.h"

namespace arris {

// All that a file can hold. Attributes are per vertex, those of `face_attributes` per triangle.
struct Shape {
  std::vector<Vec3> positions;
  std::vector<Attribute> attributes;
  ScalarType position_type = ScalarType::f64;
  std::vector<Triangle> triangles;
  std::vector<Attribute> face_attributes;
  std::vector<std::string> warnings;  // what was left behind
};

// With `points`, faces are neither read nor checked.
enum class Want { points, mesh };

// .pts files may have count lines, and their own meaning of further columns.
enum class TextKind { plain, pts };

// All throw unreadable (malformed), unsupported (a variant that arris does not read),
// out_of_memory or cancelled, never allocate more than a small multiple of the bytes given, and
// take time linear in them. A shape without vertices or faces is not an error here.
Shape read_ply(const Source& source, Want want);
Shape read_off(const Source& source, Want want);
Shape read_obj(const Source& source, Want want);
Shape read_stl(const Source& source);
Shape read_text(const Source& source, TextKind kind);

}  // namespace arris
