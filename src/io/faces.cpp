#include "io/faces.h"

#include <cmath>

#include "io/format_number.h"

namespace arris {

FaceBuilder::FaceBuilder(const Source& source, std::vector<Triangle>& triangles, Index base)
    : source_(source),
      triangles_(triangles),
      limit_(memory_limit(source.job.context()) / sizeof(Triangle)),
      base_(base) {}

void FaceBuilder::begin(std::uint64_t corners, std::size_t line) {
  line_ = line;
  corners_.clear();
  if (corners < 3)
    malformed(source_, where(), "has " + std::to_string(corners) + " corners where 3 are needed");
  if (triangles_.size() + corners > limit_)
    require_memory(source_, "triangles", triangles_.size() + corners, sizeof(Triangle));
}

void FaceBuilder::corner(double number) {
  const double index = number - static_cast<double>(base_);
  if (!(index >= 0 && index < no_index) || index != std::floor(index))
    malformed(source_, where(),
              "names vertex " + readable(number) + "; vertices are numbered from " +
                  std::to_string(base_));
  corners_.push_back(static_cast<Index>(index));
  if (corners_.back() <= highest_) return;
  highest_ = corners_.back();
  highest_face_ = next_face_;
  highest_line_ = line_;
}

void FaceBuilder::end() {
  for (std::size_t k = 2; k < corners_.size(); ++k)
    triangles_.push_back({corners_[0], corners_[k - 1], corners_[k]});
  ++next_face_;
}

std::string FaceBuilder::where() const {
  return where(next_face_, line_);
}

void FaceBuilder::check(std::uint64_t vertices) const {
  if (triangles_.empty() || highest_ < vertices) return;
  malformed(source_, where(highest_face_, highest_line_),
            "names vertex " + std::to_string(std::uint64_t{highest_} + base_) + ", but there are " +
                std::to_string(vertices) + ", numbered from " + std::to_string(base_));
}

std::string FaceBuilder::where(std::uint64_t face, std::size_t line) const {
  const std::string name = "face " + std::to_string(face);
  return line ? at_line(line) + ", " + name : name;
}

}  // namespace arris
