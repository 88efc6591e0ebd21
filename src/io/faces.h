// Collects polygons as triangles and checks their vertex indices.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "arris/types.h"
#include "io/source.h"

namespace arris {

class FaceBuilder {
 public:
  // Appends to `triangles`. Vertices are numbered from `base` (0 or 1) in the file.
  FaceBuilder(const Source& source, std::vector<Triangle>& triangles, Index base);

  // Starts a face of `corners` corners on `line` of the file (0: the file has no lines). Throws
  // unreadable for fewer than 3, out_of_memory.
  void begin(std::uint64_t corners, std::size_t line);
  // The next corner: a vertex number as the file gives it. Vertices may come later in the file.
  // Throws unreadable if no vertex can have that number.
  void corner(double number);
  // Cuts the face into a fan round its first corner.
  void end();

  // "line 12, face 3": the current face.
  std::string where() const;
  // Throws unreadable if a face names a vertex that is not there.
  void check(std::uint64_t vertices) const;

 private:
  std::string where(std::uint64_t face, std::size_t line) const;

  const Source& source_;
  std::vector<Triangle>& triangles_;
  std::vector<Index> corners_;
  std::uint64_t limit_;  // triangles that fit in memory
  std::uint64_t next_face_ = 0;
  std::size_t line_ = 0;
  Index base_;
  Index highest_ = 0;  // vertex index so far, and where
  std::uint64_t highest_face_ = 0;
  std::size_t highest_line_ = 0;
};

}  // namespace arris
