// What the tests of files share: a directory that goes away, exact comparison, random values.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "arris/io.h"

namespace arris::test {

class TempDirectory {
 public:
  TempDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "arris-test-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary directory");
    path_ = name;
  }
  ~TempDirectory() { std::filesystem::remove_all(path_); }
  TempDirectory(const TempDirectory&) = delete;
  TempDirectory& operator=(const TempDirectory&) = delete;

  std::string path(const std::string& name) const { return (path_ / name).string(); }
  std::string save(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }
  std::string load(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  // Names of all entries, hidden ones included.
  std::vector<std::string> entries() const {
    std::vector<std::string> names;
    for (const auto& e : std::filesystem::directory_iterator(path_))
      names.push_back(e.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  std::filesystem::path path_;
};

// Saves the bytes under the name and reads them.
inline Result<PointCloud> points_of(const std::string& name, const std::string& bytes) {
  const TempDirectory directory;
  return read_points(directory.save(name, bytes));
}
inline Result<Mesh> mesh_of(const std::string& name, const std::string& bytes) {
  const TempDirectory directory;
  return read_mesh(directory.save(name, bytes));
}

// The same bits, or both NaN.
inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}
inline bool same(Vec3 a, Vec3 b) {
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}
inline bool same(const Attribute& a, const Attribute& b);
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& x, const T& y) { return same(x, y); });
}

inline bool same(const Attribute& a, const Attribute& b) {
  return a.name == b.name && a.type == b.type && same(a.values, b.values);
}

// Any value of the type, NaN, infinities and subnormal numbers included.
inline double random_value(ScalarType type, std::mt19937_64& random) {
  const std::uint64_t bits = random();
  switch (type) {
    case ScalarType::i8:
      return static_cast<std::int8_t>(bits);
    case ScalarType::u8:
      return static_cast<std::uint8_t>(bits);
    case ScalarType::i16:
      return static_cast<std::int16_t>(bits);
    case ScalarType::u16:
      return static_cast<std::uint16_t>(bits);
    case ScalarType::i32:
      return static_cast<std::int32_t>(bits);
    case ScalarType::u32:
      return static_cast<std::uint32_t>(bits);
    case ScalarType::f32:
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case ScalarType::f64:
      return std::bit_cast<double>(bits);
  }
  return 0;
}

inline constexpr ScalarType all_types[] = {ScalarType::i8,  ScalarType::u8,  ScalarType::i16,
                                           ScalarType::u16, ScalarType::i32, ScalarType::u32,
                                           ScalarType::f32, ScalarType::f64};

inline ScalarType random_type(std::mt19937_64& random) {
  return all_types[random() % 8];
}

// `count` vertices with positions of the type and up to four attributes of any types.
inline PointCloud random_cloud(std::size_t count, ScalarType position_type,
                               std::mt19937_64& random) {
  PointCloud cloud;
  cloud.position_type = position_type;
  for (std::size_t k = 0; k < count; ++k)
    cloud.positions.push_back({random_value(position_type, random),
                               random_value(position_type, random),
                               random_value(position_type, random)});
  const std::size_t attributes = random() % 5;
  for (std::size_t a = 0; a < attributes; ++a) {
    cloud.attributes.push_back({std::string(1, "pqtw"[a]), random_type(random), {}});
    for (std::size_t k = 0; k < count; ++k)
      cloud.attributes[a].values.push_back(random_value(cloud.attributes[a].type, random));
  }
  return cloud;
}

}  // namespace arris::test
