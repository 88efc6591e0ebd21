// The table of bad and odd input: file, exit code, message. Whatever happens, nothing is left
// behind but the input and, on success, the mesh.
#include <gtest/gtest.h>

#include <cstring>
#include <ostream>
#include <string>
#include <vector>

#include "cli/workplace.h"

namespace arris::test {
namespace {

struct Row {
  const char* name;
  std::string file;  // the input, by its name
  std::string content;
  int exit_code;
  std::string message;       // exact, or a beginning that ends with "..."; empty on success
  std::string options = "";  // further arguments
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.name;
}

std::string ply(
    const std::string& format, const std::string& declared, const std::string& body,
    const std::string& properties = "property float x\nproperty float y\nproperty float z\n") {
  return "ply\nformat " + format + " 1.0\nelement vertex " + declared + "\n" + properties +
         "end_header\n" + body;
}

std::string ascii(const std::string& declared, const std::string& body) {
  return ply("ascii", declared, body);
}

// Little-endian float32, as on every machine this is tested on.
std::string floats(const std::vector<float>& values) {
  std::string bytes(values.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

std::string repeated(const std::string& line, int n) {
  std::string text;
  for (int i = 0; i < n; ++i) text += line;
  return text;
}

// n^3 points of a grid, scaled by `step`; many of its cubes are cospherical.
std::string grid(int n, const std::string& exponent) {
  std::string text;
  for (int i = 0; i < n * n * n; ++i)
    text += std::to_string(i % n) + exponent + " " + std::to_string(i / n % n) + exponent + " " +
            std::to_string(i / (n * n)) + exponent + "\n";
  return text;
}

std::string with_crlf(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return out;
}

const std::string tetrahedron = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string flat = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";

const Row rows[] = {
    // No file, or nothing in it.
    {"Missing", "", "", 3, "'in.ply': cannot be opened: No such file or directory"},
    {"EmptyPly", "in.ply", "", 3, "'in.ply': is empty"},
    {"EmptyXyz", "in.xyz", "", 3, "'in.xyz': is empty"},
    {"OnlyBlankLines", "in.xyz", "\n\n\n", 5, "'in.xyz': holds no points"},
    {"OnlyComments", "in.xyz", "# x y z\n# none\n", 5, "'in.xyz': holds no points"},
    {"PlyOfNoVertices", "in.ply", ascii("0", ""), 5, "'in.ply': holds no points"},
    {"UnknownExtension", "in.las", "LASF", 4,
     "'in.las': points are not read from files with the extension '.las'"},
    {"NoExtension", "in", tetrahedron, 4,
     "'in': points are not read from files with the extension ''"},
    // Too few points, or no volume.
    {"OnePoint", "in.xyz", "1 2 3\n", 6, "1 distinct point of 1 bound no volume"},
    {"TwoPoints", "in.xyz", "1 2 3\n4 5 6\n", 6, "2 distinct points of 2 bound no volume"},
    {"ThreePoints", "in.xyz", "0 0 0\n1 0 0\n0 1 0\n", 6, "3 distinct points of 3 bound no volume"},
    {"AllEqual", "in.xyz", repeated("1 2 3\n", 100), 6, "1 distinct point of 100 bound no volume"},
    {"Collinear", "in.xyz", "0 0 0\n1 1 1\n2 2 2\n3 3 3\n4 4 4\n", 6,
     "all 5 distinct points are on one line, so they bound no volume"},
    {"FourCoplanar", "in.xyz", flat, 6,
     "all 4 distinct points are in one plane, so they bound no volume"},
    {"CoplanarGrid", "in.xyz", "0 0 5\n1 0 5\n2 0 5\n0 1 5\n1 1 5\n2 1 5\n0 2 5\n1 2 5\n2 2 5\n", 6,
     "all 9 distinct points are in one plane, so they bound no volume"},
    {"FourDistinctAmongDuplicates", "in.xyz", repeated(flat, 50), 6,
     "all 4 distinct points are in one plane, so they bound no volume"},
    {"NothingEnclosed", "in.xyz", tetrahedron + "1 1 1\n", 7,
     "the points do not enclose a volume: nothing is inside"},
    // Numbers that are none, or extreme.
    {"NotANumber", "in.xyz", tetrahedron + "nan 0 0\n1 1 1\n", 5,
     "1 of 6 points have a coordinate that is not finite; the first is point 4: ..."},
    {"Infinite", "in.xyz", tetrahedron + "0 inf 0\n1 1 1\n", 5,
     "1 of 6 points have a coordinate that is not finite; the first is point 4: ..."},
    {"BinaryNan", "in.ply",
     ply("binary_little_endian", "1", std::string("\0\0\xC0\x7F", 4) + floats({0, 0})), 5,
     "1 of 1 points have a coordinate that is not finite; the first is point 0: ..."},
    {"OnlyNan", "in.xyz", repeated("nan nan nan\n", 10), 5, "the cloud has no finite points",
     "--drop-non-finite"},
    {"NanDroppedLeavesTooFew", "in.xyz", "0 0 0\n1 0 0\nnan 0 0\ninf 0 0\n", 6,
     "2 distinct points of 4 bound no volume", "--drop-non-finite"},
    {"NanDropped", "in.xyz", sphere_xyz(200) + "nan 0 0\n0 -inf 0\n", 0, "", "--drop-non-finite"},
    {"HugeCoordinates", "in.xyz", grid(3, "e300"), 0, ""},
    {"TinyCoordinates", "in.xyz", grid(3, "e-300"), 0, ""},
    {"BeyondDouble", "in.xyz", tetrahedron + "1e999 0 0\n", 5,
     "1 of 5 points have a coordinate that is not finite; the first is point 4: ..."},
    {"CosphericalGrid", "in.xyz", grid(5, ""), 0, ""},
    {"GarbageInNumber", "in.xyz", "0 0 0\n1 0 0\n0 1x 0\n0 0 1\n", 3,
     "'in.xyz': line 3, column 2: '1x' is not a number"},
    {"CommaAsDecimalPoint", "in.xyz", "0,5 0,5 0,5\n1,5 0,5 0,5\n", 3, "'in.xyz': line 1..."},
    {"WordsInText", "in.txt", "hello world this is text\n", 3, "'in.txt': line 1..."},
    {"TooFewColumns", "in.xyz", "0 0\n1 0\n", 3,
     "'in.xyz': line 1: has 2 columns where x, y and z are needed"},
    {"RaggedColumns", "in.xyz", "0 0 0\n1 0 0\n0 1\n", 3,
     "'in.xyz': line 3: has 2 columns where the lines before have 3"},
    {"BinaryAsText", "in.xyz", std::string("\0\1\2\3\4\5", 6), 3,
     "'in.xyz': is binary data, not text"},
    // PLY.
    {"BinaryGarbage", "in.ply", std::string("\x7F\x45\x4C\x46\0\1\2\3", 8), 3,
     "'in.ply': line 1: does not say 'ply', so this is not a PLY file"},
    {"HeaderCutOff", "in.ply", "ply\nformat ascii 1.0\nelement ver", 3, "'in.ply': line 3..."},
    {"NoEndHeader", "in.ply", "ply\nformat ascii 1.0\nelement vertex 4\n", 3,
     "'in.ply': line 3: the file ends within the header"},
    {"NoFormat", "in.ply", "ply\nelement vertex 0\nend_header\n", 3,
     "'in.ply': line 3: the header has no format line"},
    {"FutureVersion", "in.ply", "ply\nformat ascii 2.0\nend_header\n", 4,
     "'in.ply': line 2: PLY version '2.0' is not 1.0"},
    {"AsciiBodyCutOff", "in.ply", ascii("5", tetrahedron), 3,
     "'in.ply': element vertex: file ends early, 5 are declared and at most 4 fit"},
    {"BinaryBodyCutOff", "in.ply", ply("binary_little_endian", "4", floats({0, 0, 0, 1, 0})), 3,
     "'in.ply': vertex 1 of 4: file ends early"},
    {"CountTooHigh", "in.ply", ascii("1000000", tetrahedron), 3, "'in.ply': element vertex..."},
    {"CountHuge", "in.ply", ply("binary_little_endian", "18446744073709551615", floats({0, 0, 0})),
     3, "'in.ply': vertex 1 of 18446744073709551615: file ends early"},
    {"CountBeyond64Bits", "in.ply", ascii("99999999999999999999", tetrahedron), 3,
     "'in.ply': line 3: the count '99999999999999999999' is absurdly large"},
    {"CountNegative", "in.ply", ascii("-4", tetrahedron), 3,
     "'in.ply': line 3: negative count '-4'"},
    {"CountOfLetters", "in.ply", ascii("four", tetrahedron), 3,
     "'in.ply': line 3: 'four' is not a count"},
    {"NoVertexElement", "in.ply", "ply\nformat ascii 1.0\nelement face 0\nend_header\n", 3,
     "'in.ply': header: declares no element vertex"},
    {"NoX", "in.ply", ply("ascii", "1", "0 0\n", "property float y\nproperty float z\n"), 3,
     "'in.ply': element vertex: has no property x"},
    {"XIsAList", "in.ply",
     ply("ascii", "1", "1 0 0 0\n",
         "property list uchar float x\nproperty float y\nproperty float z\n"),
     3, "'in.ply': element vertex: has no property x"},
    {"UnknownType", "in.ply", ply("ascii", "1", "0 0 0\n", "property quad x\n"), 3,
     "'in.ply': line 4: 'quad' is not a type of PLY"},
    {"WordInBody", "in.ply", ascii("4", "0 0 0\n1 0 0\n0 one 0\n0 0 1\n"), 3,
     "'in.ply': line 10, vertex 2 of 4: 'one' is not a number"},
    // OFF, OBJ, PTS.
    {"OffWithoutKeyword", "in.off", "NOFF3\n4 0 0\n", 3,
     "'in.off': line 1: starts with 'NOFF3', not OFF"},
    {"OffCutOff", "in.off", "OFF\n400 0 0\n0 0 0\n", 3,
     "'in.off': line 2: file ends early, 400 vertices are declared and at most 1 fit"},
    {"ObjWithoutVertices", "in.obj", "o nothing\n", 5, "'in.obj': holds no points"},
    {"ObjShortVertex", "in.obj", "v 0 0 0\nv 1 0\n", 3,
     "'in.obj': line 2, vertex 2: has 2 numbers where 3, 4, 6 or 7 are expected"},
    {"PtsCountTooHigh", "in.pts", "99\n" + tetrahedron, 3,
     "'in.pts': line 1: file ends early, 99 points are declared and at most 4 fit"},
    // Odd but good.
    {"Duplicates", "in.xyz", repeated(sphere_xyz(200), 3), 0, ""},
    {"CarriageReturns", "in.xyz", with_crlf(sphere_xyz(200)), 0, ""},
    {"NoFinalNewline", "in.xyz", sphere_xyz(200) + "0 0 1", 0, ""},
    {"TabsAndBlanks", "in.txt", "0\t0  0\n" + sphere_xyz(200), 0, ""},
    {"FarFromTheOrigin", "in.xyz", sphere_xyz(200, 5e6), 0, ""},
    // Limits.
    {"MemoryTooSmall", "in.xyz", sphere_xyz(1000), 9, "1000 points need about ...",
     "--memory-limit 100K"},
};

class BadInput : public testing::TestWithParam<Row> {};

TEST_P(BadInput, EndsAsTheTableSays) {
  const Row& row = GetParam();
  const Workplace place;
  if (!row.file.empty()) place.write(row.file, row.content);
  const std::string input = row.file.empty() ? "in.ply" : row.file;
  const Outcome outcome =
      place.arris("reconstruct " + input + " -o out.ply --quiet " + row.options);
  EXPECT_EQ(outcome.exit_code, row.exit_code) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  std::set<std::string> expected;
  if (!row.file.empty()) expected.insert(row.file);
  if (row.exit_code == 0) {
    expected.insert("out.ply");
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(place.arris("check --quiet out.ply").exit_code, 0);
  } else {
    const PrintedError error = printed_error(outcome.err);
    EXPECT_TRUE(matches(error.message, row.message)) << outcome.err;
    EXPECT_NE(error.message, "") << outcome.err;
    EXPECT_NE(error.remedy, "") << outcome.err;
  }
  EXPECT_EQ(place.entries(), expected);
  if (!row.file.empty()) {
    EXPECT_EQ(place.read(row.file), row.content);
  }
}

INSTANTIATE_TEST_SUITE_P(Table, BadInput, testing::ValuesIn(rows),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(BadInput, ADirectory) {
  const Workplace place;
  std::filesystem::create_directory(place.path("in.ply"));
  const Outcome outcome = place.arris("reconstruct in.ply -o out.ply --quiet");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(printed_error(outcome.err).message, "'in.ply': is a directory");
  EXPECT_EQ(place.entries(), std::set<std::string>{"in.ply"});
}

TEST(BadInput, APipe) {
  const Workplace place;
  const Outcome outcome =
      place.shell("mkfifo in.ply; exec \"$ARRIS\" reconstruct in.ply -o out.ply --quiet");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(printed_error(outcome.err).message, "'in.ply': is not a regular file");
}

TEST(BadInput, AFileClosedToReading) {
  const Workplace place;
  place.write("in.xyz", tetrahedron);
  if (place.shell("chmod 000 in.xyz; cat in.xyz").exit_code == 0)
    GTEST_SKIP() << "this user may read everything";
  const Outcome outcome = place.arris("reconstruct in.xyz -o out.ply --quiet");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(printed_error(outcome.err).message, "'in.xyz': cannot be opened: Permission denied");
}

}  // namespace
}  // namespace arris::test
