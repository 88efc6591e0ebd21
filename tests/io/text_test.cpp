#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <clocale>

#include "io/format_number.h"
#include "io/text_scan.h"
#include "support.h"

namespace arris::test {
namespace {

using Names = std::vector<std::string>;

Names names_of(const PointCloud& cloud) {
  Names names;
  for (const Attribute& a : cloud.attributes) names.push_back(a.name);
  return names;
}

double parsed(std::string_view text) {
  double value = -77;
  return parse_number(text, value) ? value : -77;
}

TEST(ParseNumber, TakesEveryWayToWriteOne) {
  EXPECT_EQ(parsed("1.5"), 1.5);
  EXPECT_EQ(parsed("+1.5"), 1.5);
  EXPECT_EQ(parsed("-.5e+2"), -50);
  EXPECT_EQ(parsed("1E300"), 1e300);
  EXPECT_TRUE(std::isnan(parsed("NaN")));
  EXPECT_TRUE(std::isnan(parsed("-nan(ind)")));
  EXPECT_EQ(parsed("-Inf"), -HUGE_VAL);
  EXPECT_EQ(parsed("infinity"), HUGE_VAL);
}

TEST(ParseNumber, OverflowsToInfinityAndUnderflowsToZero) {
  const std::string zeros(400, '0');
  EXPECT_EQ(parsed("1e400"), HUGE_VAL);
  EXPECT_EQ(parsed("-1e400"), -HUGE_VAL);
  EXPECT_EQ(parsed("1" + zeros), HUGE_VAL);
  EXPECT_EQ(parsed("1" + zeros + ".5e-2"), HUGE_VAL);
  EXPECT_EQ(parsed("1e99999999999999999999"), HUGE_VAL);
  EXPECT_TRUE(same(parsed("1e-400"), 0.0));
  EXPECT_TRUE(same(parsed("-1e-400"), -0.0));
  EXPECT_TRUE(same(parsed("0." + zeros + "1"), 0.0));
  EXPECT_TRUE(same(parsed("0." + zeros + "1e5"), 0.0));
  EXPECT_TRUE(same(parsed("1e-99999999999999999999"), 0.0));
  EXPECT_EQ(parsed("4.9e-324"), std::numeric_limits<double>::denorm_min());
}

TEST(ParseNumber, RefusesEverythingElse) {
  for (const char* text : {"", "+", "-", "+-1", "++1", "1,5", "1.5x", "x", "0x10", "1 2", "e5"})
    EXPECT_EQ(parsed(text), -77) << text;
}

TEST(ParseNumber, DoesNotHeedTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* comma : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE"}) std::setlocale(LC_ALL, comma);
  EXPECT_EQ(parsed("1.5"), 1.5);
  EXPECT_EQ(format_number(1.5), "1.5");
  std::setlocale(LC_ALL, before.c_str());
}

RC_GTEST_PROP(Text, RandomCloudsComeBackExactly, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  PointCloud cloud = random_cloud(1 + random() % 20, ScalarType::f64, random);
  const std::string gap = *rc::gen::element<std::string>(" ", "\t", ",", ";", ", ", "  ");
  const std::string line_end = *rc::gen::element<std::string>("\n", "\r\n", "\r", "\n\n");
  const std::string name = *rc::gen::element<std::string>("a.xyz", "a.TXT", "a.csv", "a.asc");
  std::string text = "# comment" + line_end + "z" + gap + "X" + gap + "y";
  for (Attribute& a : cloud.attributes) {
    a.type = ScalarType::f64;  // text has no types
    text += gap + a.name;
  }
  text += line_end;
  for (std::size_t k = 0; k < cloud.positions.size(); ++k) {
    const Vec3 p = cloud.positions[k];
    text += format_number(p.z) + gap + format_number(p.x) + gap + format_number(p.y);
    for (const Attribute& a : cloud.attributes) text += gap + format_number(a.values[k]);
    text += line_end;
  }
  const auto read = points_of(name, text);
  RC_ASSERT(static_cast<bool>(read));
  RC_ASSERT(same(read->positions, cloud.positions));
  RC_ASSERT(same(read->attributes, cloud.attributes));
}

TEST(Text, NamesColumnsByTheirNumber) {
  struct Case {
    const char* file;
    const char* text;
    Names names;
    ScalarType type;
  };
  const Case cases[] = {
      {"a.xyz", "1 2 3\n", {}, ScalarType::f64},
      {"a.xyz", "1 2 3 4\n", {"c3"}, ScalarType::f64},
      {"a.xyz", "1 2 3 0 0.6 -0.8\n", {"nx", "ny", "nz"}, ScalarType::f64},
      {"a.xyz", "1 2 3 0 0 1\n", {"nx", "ny", "nz"}, ScalarType::f64},
      {"a.xyz", "1 2 3 0 128 255\n", {"red", "green", "blue"}, ScalarType::u8},
      {"a.txt", "1 2 3 4 5 6 7\n", {"c3", "c4", "c5", "c6"}, ScalarType::f64},
      {"a.pts", "1\n1 2 3 -99\n", {"intensity"}, ScalarType::f64},
      {"a.pts", "1 2 3 4 5 6\n", {"red", "green", "blue"}, ScalarType::u8},
      {"a.pts", "1\n1 2 3 9 5 6 7\n", {"intensity", "red", "green", "blue"}, ScalarType::f64},
  };
  for (const Case& c : cases) {
    const auto cloud = points_of(c.file, c.text);
    ASSERT_TRUE(cloud) << c.text << cloud.error().message;
    EXPECT_EQ(names_of(*cloud), c.names) << c.text;
    if (!c.names.empty()) {
      EXPECT_EQ(cloud->attributes[0].type, c.type) << c.text;
    }
    EXPECT_EQ(cloud->positions[0], (Vec3{1, 2, 3})) << c.text;
  }
}

TEST(Text, TakesNamesFromQuotesAndComments) {
  const auto quotes =
      points_of("a.csv", "\xEF\xBB\xBF\"x\",\"y\",\"z\",\"R\",\"scan id\"\n1,2,3,7,4\n");
  ASSERT_TRUE(quotes) << quotes.error().message;
  EXPECT_EQ(names_of(*quotes), (Names{"R", "scan id"}));
  EXPECT_EQ(quotes->attributes[0].type, ScalarType::u8);
  const auto comment = points_of("a.asc", "// made by hand\n//X Y Z depth\n1 2 3 4\n");
  ASSERT_TRUE(comment);
  EXPECT_EQ(names_of(*comment), (Names{"depth"}));
}

TEST(Text, MissingAttributesAreNotANumber) {
  const auto cloud = points_of("a.csv", "x,y,z,q,p\n1,2,3,,5\n1,2,3,4,5,\n");
  ASSERT_TRUE(cloud) << cloud.error().message;
  EXPECT_TRUE(same(cloud->attributes[0].values, {NAN, 4.0}));
}

TEST(Text, PtsMayHoldSeveralScans) {
  const auto cloud = points_of("a.pts", "2\n1 2 3\n4 5 6\n1\n7 8 9\n");
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->positions.size(), 3u);
}

}  // namespace
}  // namespace arris::test
