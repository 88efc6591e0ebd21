// Clouds and answers as the tests of the whole pipeline need them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "arris/reconstruct.h"
#include "base/vec.h"
#include "support/samplers.h"
#include "support/shapes.h"

namespace arris::test {

inline PointCloud cloud_of(std::vector<Vec3> positions) {
  PointCloud cloud;
  cloud.positions = std::move(positions);
  return cloud;
}

inline PointCloud feature_cloud(const std::string& shape, std::size_t n, std::uint64_t seed = 1) {
  return cloud_of(sample_feature(make_shape(shape).mesh, n, seed));
}

inline PointCloud blue_cloud(const std::string& shape, std::size_t n, std::uint64_t seed = 1) {
  return cloud_of(sample_blue(make_shape(shape).mesh, n, seed));
}

inline Options paper() {
  Options options;
  options.method = Method::paper;
  return options;
}

// The failure's text for an assertion, or empty.
template <class T>
std::string said(const Result<T>& result) {
  if (result) return "";
  return std::string(name(result.error().code)) + ": " + result.error().message;
}

// The code of a failure; a success is no failure (0 is no ErrorCode).
template <class T>
ErrorCode code_of(const Result<T>& result) {
  return result ? ErrorCode{} : result.error().code;
}

inline void expect_same_mesh(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.attributes, b.attributes);
}

}  // namespace arris::test
