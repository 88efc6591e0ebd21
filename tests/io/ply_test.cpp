#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <charconv>

#include "support.h"

namespace arris::test {
namespace {

enum class Encoding { ascii, little, big };

const char* type_name(ScalarType type, bool alias) {
  static constexpr const char* names[][2] = {
      {"char", "int8"}, {"uchar", "uint8"}, {"short", "int16"},   {"ushort", "uint16"},
      {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"}};
  return names[static_cast<std::size_t>(type)][alias];
}

template <class T>
std::string bytes_of(T value, bool big) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  if (big != (std::endian::native == std::endian::big)) std::reverse(bytes, bytes + sizeof(T));
  return {bytes, sizeof(T)};
}

template <class T>
std::string encode_as(double value, Encoding encoding) {
  const T typed = static_cast<T>(value);
  if (encoding != Encoding::ascii) return bytes_of(typed, encoding == Encoding::big);
  char digits[64];
  return {digits, std::to_chars(digits, digits + 64, typed).ptr};
}

std::string encode(double value, ScalarType type, Encoding encoding) {
  switch (type) {
    case ScalarType::i8:
      return encode_as<std::int8_t>(value, encoding);
    case ScalarType::u8:
      return encode_as<std::uint8_t>(value, encoding);
    case ScalarType::i16:
      return encode_as<std::int16_t>(value, encoding);
    case ScalarType::u16:
      return encode_as<std::uint16_t>(value, encoding);
    case ScalarType::i32:
      return encode_as<std::int32_t>(value, encoding);
    case ScalarType::u32:
      return encode_as<std::uint32_t>(value, encoding);
    case ScalarType::f32:
      return encode_as<float>(value, encoding);
    case ScalarType::f64:
      return encode_as<double>(value, encoding);
  }
  return {};
}

// A property of the vertices in the file: a column of the cloud, or a list that holds nothing of
// it.
struct Column {
  std::string name;
  ScalarType type = ScalarType::f64;
  std::vector<double> values;
  bool is_list = false;
};

std::vector<Column> columns_of(const PointCloud& cloud) {
  std::vector<Column> columns(3);
  for (std::size_t k = 0; k < 3; ++k) {
    columns[k].name = std::string(1, "xyz"[k]);
    columns[k].type = cloud.position_type;
    for (const Vec3& p : cloud.positions)
      columns[k].values.push_back(k == 0 ? p.x : k == 1 ? p.y : p.z);
  }
  for (const Attribute& a : cloud.attributes) columns.push_back({a.name, a.type, a.values, false});
  return columns;
}

// The file, with random type names, an element of lists before and one after the vertices.
std::string file_of(const std::vector<Column>& columns, std::size_t rows, Encoding encoding,
                    const std::string& line_end, std::mt19937_64& random) {
  const bool ascii = encoding == Encoding::ascii;
  const std::string gap = ascii ? " " : "", row_end = ascii ? line_end : "";
  const auto number = [&](double v, ScalarType t) { return encode(v, t, encoding) + gap; };
  std::vector<std::string> header = {"ply"};
  header.push_back(std::string("format ") +
                   (ascii                          ? "ascii"
                    : encoding == Encoding::little ? "binary_little_endian"
                                                   : "binary_big_endian") +
                   " 1.0");
  header.insert(header.end(), {"comment element vertex 7", "obj_info any", "element before 2",
                               "property list uchar short data", "property double weight",
                               "element vertex " + std::to_string(rows)});
  for (const Column& c : columns)
    header.push_back(std::string("property ") + (c.is_list ? "list ushort " : "") +
                     type_name(c.type, random() % 2) + " " + c.name);
  header.insert(header.end(), {"element after 1", "property int number", "end_header"});
  std::string file;
  for (const std::string& line : header) file += line + line_end;
  for (int k = 0; k < 2; ++k) {
    file += number(k, ScalarType::u8);
    for (int j = 0; j < k; ++j) file += number(-5, ScalarType::i16);
    file += number(2.5, ScalarType::f64) + row_end;
  }
  for (std::size_t row = 0; row < rows; ++row) {
    for (const Column& c : columns) {
      const std::size_t size = c.is_list ? row % 3 : 1;
      if (c.is_list) file += number(static_cast<double>(size), ScalarType::u16);
      // Text keeps more digits of a coordinate than its type has, so there all of them are given.
      const bool coordinate = c.name == "x" || c.name == "y" || c.name == "z";
      const ScalarType type = ascii && coordinate ? ScalarType::f64 : c.type;
      for (std::size_t j = 0; j < size; ++j) file += number(c.values[row], type);
    }
    file += row_end;
  }
  return file + number(1, ScalarType::i32) + row_end;
}

RC_GTEST_PROP(Ply, RandomCloudsComeBackExactly, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const auto encoding = *rc::gen::element(Encoding::ascii, Encoding::little, Encoding::big);
  const std::string line_end = *rc::gen::element<std::string>("\n", "\r\n", "\r");
  const PointCloud cloud = random_cloud(1 + random() % 20, random_type(random), random);
  std::vector<Column> columns = columns_of(cloud);
  if (random() % 2) columns.push_back({"list", random_type(random), columns[0].values, true});
  if (columns.back().is_list)
    for (double& v : columns.back().values) v = 1;
  std::shuffle(columns.begin(), columns.end(), random);

  const auto read =
      points_of("cloud.ply", file_of(columns, cloud.positions.size(), encoding, line_end, random));
  RC_ASSERT(static_cast<bool>(read));
  RC_ASSERT(same(read->positions, cloud.positions));
  RC_ASSERT(read->position_type == cloud.position_type);
  std::vector<Attribute> attributes = read->attributes;
  std::sort(attributes.begin(), attributes.end(),
            [](const Attribute& a, const Attribute& b) { return a.name < b.name; });
  RC_ASSERT(same(attributes, cloud.attributes));
}

const std::string xyz_header =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\n";

TEST(Ply, AsciiKeepsDigitsThatItsTypeCannotHold) {
  const auto cloud = points_of(
      "c.ply",
      xyz_header + "property float q\nend_header\n0.1 1e300 1e-300 0.1\n1e400 -1e400 nan inf\n");
  ASSERT_TRUE(cloud) << cloud.error().message;
  EXPECT_TRUE(same(cloud->positions[0], Vec3{0.1, 1e300, 1e-300}));
  EXPECT_TRUE(same(cloud->positions[1], Vec3{HUGE_VAL, -HUGE_VAL, NAN}));
  EXPECT_EQ(cloud->attributes[0].values[0], static_cast<double>(0.1f));
  EXPECT_EQ(cloud->attributes[0].values[1], HUGE_VAL);
}

TEST(Ply, MixedPositionTypesAreDoubles) {
  const auto cloud = points_of("c.ply",
                               "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                               "property int y\nproperty float z\nend_header\n1 2 3\n");
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->position_type, ScalarType::f64);
}

TEST(Ply, WarnsOfWhatItLeavesOut) {
  const auto cloud = points_of("c.ply", xyz_header +
                                            "property list uchar int ring\nelement face 1\n"
                                            "property list uchar int vertex_indices\nend_header\n"
                                            "0 0 0 2 7 8\n1 1 1 0\n3 0 1 1\n");
  ASSERT_TRUE(cloud);
  ASSERT_EQ(cloud->warnings.size(), 2u);
  EXPECT_NE(cloud->warnings[0].find("'ring'"), std::string::npos);
  EXPECT_NE(cloud->warnings[1].find("'face' (1)"), std::string::npos);
}

TEST(Ply, WarnsOfDataAfterTheLastElement) {
  const auto cloud = points_of("c.ply", xyz_header + "end_header\n0 0 0\n1 1 1\n2 2 2\n");
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->positions.size(), 2u);
  EXPECT_EQ(cloud->warnings.size(), 1u);
}

TEST(Ply, PolygonsBecomeFansAndFacesMayComeFirst) {
  const auto mesh = mesh_of("m.ply",
                            "ply\nformat ascii 1.0\nelement face 2\n"
                            "property uchar group\nproperty list uint8 uint vertex_index\n"
                            "element vertex 5\nproperty double x\nproperty double y\n"
                            "property double z\nproperty uchar red\nend_header\n"
                            "9 5 0 1 2 3 4\n9 3 4 3 2\n"
                            "0 0 0 1\n1 0 0 2\n2 1 0 3\n1 2 0 4\n0 1 0 255\n");
  ASSERT_TRUE(mesh) << mesh.error().message;
  const std::vector<Triangle> expected = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {4, 3, 2}};
  EXPECT_EQ(mesh->triangles, expected);
  ASSERT_EQ(mesh->attributes.size(), 1u);
  EXPECT_EQ(mesh->attributes[0], (Attribute{"red", ScalarType::u8, {1, 2, 3, 4, 255}}));
}

}  // namespace
}  // namespace arris::test
