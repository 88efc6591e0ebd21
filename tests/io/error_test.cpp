// Every way a file can be wrong: its code, and what the message must name.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>

#include "support.h"

namespace arris::test {
namespace {

struct Case {
  const char* file;
  std::string bytes;
  ErrorCode code;
  std::vector<std::string> message;  // parts
};

const std::string ply = "ply\nformat ascii 1.0\n";
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string two = ply + "element vertex 2\n" + xyz;
const std::string corners = "property list uchar int vertex_indices\n";
const std::string binary = "ply\nformat binary_little_endian 1.0\n";
constexpr auto unreadable = ErrorCode::unreadable;
constexpr auto unsupported = ErrorCode::unsupported;

void expect(const Case& c, const Error& error, bool failed) {
  ASSERT_TRUE(failed) << c.file << "\n" << c.bytes;
  EXPECT_EQ(error.code, c.code) << error.message;
  for (const std::string& part : c.message)
    EXPECT_NE(error.message.find(part), std::string::npos) << error.message << "\nlacks: " << part;
  EXPECT_NE(error.message.find(c.file), std::string::npos) << error.message;
  EXPECT_FALSE(error.remedy.empty());
  EXPECT_FALSE(error.message.ends_with('.'));
}

const Case point_cases[] = {
    {"a.ply", "", unreadable, {"is empty"}},
    {"a.doc", "1 2 3\n", unsupported, {"'.doc'"}},
    {"a", "1 2 3\n", unsupported, {"extension ''"}},
    // The header of PLY.
    {"a.ply", "solid\n", unreadable, {"line 1", "not a PLY"}},
    {"a.ply",
     std::string("\x7F"
                 "ELF\0\1\2",
                 7),
     unreadable,
     {"not a PLY"}},
    {"a.ply", "ply\nformat ascii 1.0\nelement ver", unreadable, {"line 3", "a name and a count"}},
    {"a.ply",
     "ply\nformat ascii 1.0\nelement vertex 2\n",
     unreadable,
     {"line 3", "within the header"}},
    {"a.ply",
     "ply\n"
     "element vertex 1\n" +
         xyz + "end_header\n1 2 3\n",
     unreadable,
     {"no format"}},
    {"a.ply", "ply\nformat ebcdic 1.0\n", unreadable, {"line 2", "'ebcdic'"}},
    {"a.ply", "ply\nformat ascii 2.0\n", unsupported, {"line 2", "'2.0'"}},
    {"a.ply", ply + "\x01\xFF\n", unreadable, {"line 3", "'?\?'"}},
    {"a.ply", ply + "element vertex -3\n", unreadable, {"line 3", "negative count '-3'"}},
    {"a.ply", ply + "element vertex many\n", unreadable, {"line 3", "'many' is not a count"}},
    {"a.ply",
     ply + "element vertex 99999999999999999999\n",
     unreadable,
     {"line 3", "absurdly large"}},
    {"a.ply", ply + "property float x\n", unreadable, {"line 3", "before the first element"}},
    {"a.ply", ply + "element vertex 1\nproperty real x\n", unreadable, {"line 4", "'real'"}},
    {"a.ply", ply + "element vertex 1\nproperty list uchar\n", unreadable, {"line 4", "''"}},
    {"a.ply", ply + "element vertex 1\nproperty float\n", unreadable, {"line 4", "no name"}},
    {"a.ply", two + "property int x\n", unreadable, {"line 7", "'x' is declared twice"}},
    {"a.ply", two + "element vertex 2\n", unreadable, {"'vertex' is declared twice"}},
    {"a.ply", ply + "end_header\n", unreadable, {"no element vertex"}},
    {"a.ply",
     ply + "element vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n",
     unreadable,
     {"no property z"}},
    // The body of PLY.
    {"a.ply", two + "end_header\n1 2 3\n", unreadable, {"element vertex", "2 are declared"}},
    {"a.ply", two + "end_header\n1.25 2.25 3.25\n", unreadable, {"vertex 1 of 2: file ends early"}},
    {"a.ply",
     two + "end_header\n1 2 3\n1.2345 2",
     unreadable,
     {"line 9, vertex 1 of 2", "ends early"}},
    {"a.ply",
     two + "end_header\n1 2\n1.234 2.345 3\n",
     unreadable,
     {"line 8, vertex 0", "fewer values"}},
    {"a.ply", two + "end_header\n1 2 3\n1 2 3 4\n", unreadable, {"line 9, vertex 1", "'4'"}},
    {"a.ply",
     two + "end_header\n1 2 3\n1 2,5 3\n",
     unreadable,
     {"line 9, vertex 1", "'2,5' is not a number"}},
    {"a.ply",
     two + "property uchar q\nend_header\n1 2 3 4\n1 2 3 256\n",
     unreadable,
     {"line 10", "'256'", "uchar"}},
    {"a.ply",
     two + "property int q\nend_header\n1 2 3 4\n1 2 3 nan\n",
     unreadable,
     {"'nan'", "int"}},
    {"a.ply",
     two + "property list char int q\nend_header\n1 2 3 0\n1 2 3 -1 0\n",
     unreadable,
     {"vertex 1", "negative"}},
    {"a.ply",
     two + "property list int int q\nend_header\n1 2 3 0\n1 2 3 2000000000 0\n",
     unreadable,
     {"vertex 1", "2000000000", "more than"}},
    {"a.ply",
     two + "property list float int q\nend_header\n1 2 3 0\n1 2 3 1.5 0\n",
     unreadable,
     {"vertex 1", "broken count"}},
    {"a.ply",
     ply + "element vertex 1000000000000\n" + xyz + "end_header\n1 2 3\n",
     unreadable,
     {"1000000000000", "ends early"}},
    {"a.ply",
     ply + "element vertex 18446744073709551615\n" + xyz + "end_header\n1 2 3\n",
     unreadable,
     {"ends early"}},
    {"a.ply",
     binary + "element vertex 1000\n" + xyz + "end_header\n" + std::string(812 * 12 + 5, 'a'),
     unreadable,
     {"vertex 812 of 1000: file ends early"}},
    {"a.ply",
     binary + "element vertex 18446744073709551615\n" + xyz + "end_header\n",
     unreadable,
     {"vertex 0 of", "ends early"}},
    {"a.ply",
     binary + "element vertex 2\n" + xyz + "property list uint uint q\nend_header\n" +
         std::string(40, '\xFF'),
     unreadable,
     {"vertex 0 of 2", "4294967295"}},
    {"a.ply",
     binary + "element tri 9\nproperty list uchar int q\nelement vertex 1\n" + xyz +
         "end_header\n" + std::string(9, '\1'),
     unreadable,
     {"tri 1 of 9", "ends early"}},
    {"a.ply",
     ply + "element vertex 0\n" + xyz + "end_header\n",
     ErrorCode::bad_points,
     {"no points"}},
    // Text.
    {"a.xyz", "1 2\n", unreadable, {"line 1", "2 columns"}},
    {"a.xyz", "1 2 3\n\n# c\n1 2\n", unreadable, {"line 4", "2 columns", "have 3"}},
    {"a.xyz", "1 2 3\n1 2 3 4\n", unreadable, {"line 2", "4 columns"}},
    {"a.xyz", "1 2 3\n1 two 3\n", unreadable, {"line 2, column 2", "'two' is not a number"}},
    {"a.xyz", "1 abc 3\n", unreadable, {"line 1, column 2", "'abc'"}},
    {"a.csv", "1,5;2,5;3,5\n", unreadable, {"line 1"}},
    {"a.csv", "x,y,z\n1,,3\n", unreadable, {"line 2, column 2", "'' is not a number"}},
    {"a.csv", "x,y,height\n1,2,3\n", unreadable, {"line 1", "one z"}},
    {"a.csv", "x,y,z,q,q\n1,2,3,4,5\n", unreadable, {"line 1", "'q' twice"}},
    {"a.csv", "x,y,z\n", ErrorCode::bad_points, {"no points"}},
    {"a.xyz", "# nothing\n", ErrorCode::bad_points, {"no points"}},
    {"a.txt", "no points here\n", unreadable, {"line 1"}},
    {"a.txt", std::string("1 2 3\n\0\0\0", 9), unreadable, {"binary"}},
    {"a.txt",
     std::string("\xFF\xFE"
                 "1\0",
                 4),
     unreadable,
     {"UTF-16"}},
    {"a.pts", "3\n1 2 3\n4.5 5.5 6.5\n", unreadable, {"has 2 points", "declares 3"}},
    {"a.pts", "1\n1 2 3\n4 5 6\n", unreadable, {"has 2 points", "declares 1"}},
    {"a.pts", "1000000000000\n1 2 3\n", unreadable, {"line 1", "1000000000000"}},
    {"a.pts", "99999999999999999999\n1 2 3\n", unreadable, {"line 1", "absurdly"}},
    // OFF and OBJ.
    {"a.off", "PLY\n", unreadable, {"line 1", "'PLY'"}},
    {"a.off", "4OFF\n1 0 0\n1 2 3 4\n", unsupported, {"'4OFF'"}},
    {"a.off", "OFF BINARY\n", unsupported, {"binary OFF"}},
    {"a.off", "OFF\n", unreadable, {"before the counts"}},
    {"a.off", "OFF\n-2 0 0\n", unreadable, {"line 2", "negative count '-2'"}},
    {"a.off", "OFF\n2 x 0\n", unreadable, {"line 2", "'x' is not a count"}},
    {"a.off", "OFF\n99999999 0 0\n1 2 3\n", unreadable, {"99999999 vertices"}},
    {"a.off",
     "OFF\n2 0 0\n1.23456 2 3\n# a comment\n",
     unreadable,
     {"vertex 1 of 2", "ends early"}},
    {"a.off", "OFF\n1 0 0\n1.5 2\n", unreadable, {"line 3, vertex 0", "has 2 numbers"}},
    {"a.off", "COFF\n1 0 0\n1 2 3 4\n", unreadable, {"line 3, vertex 0", "6 are expected"}},
    {"a.off", "OFF\n1 0 0\n1 2 b.4\n", unreadable, {"line 3, vertex 0", "'b.4'"}},
    {"a.obj", "o thing\n", ErrorCode::bad_points, {"no points"}},
    {"a.obj", "v 1 2\n", unreadable, {"line 1, vertex 1", "has 2 numbers"}},
    {"a.obj", "v 1 2 3 4 5\n", unreadable, {"has 5 numbers"}},
    {"a.obj", "v 1 2 3 4 5 6 7 8\n", unreadable, {"more than 7"}},
    {"a.obj", "v 1 2 3\nv 1 2 z\n", unreadable, {"line 2, vertex 2", "'z'"}},
    {"a.obj", std::string("v\0", 2), unreadable, {"binary"}},
};

TEST(ReadPoints, EveryFailureIsTypedAndNamesThePlace) {
  for (const Case& c : point_cases) {
    const auto result = points_of(c.file, c.bytes);
    expect(c, result.error(), !result);
  }
}

const std::string square = "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n";
const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";

const Case mesh_cases[] = {
    {"a.xyz", "1 2 3\n", unsupported, {"'.xyz'"}},
    {"a.ply", two + "end_header\n1 2 3\n4 5 6\n", unreadable, {"no faces"}},
    {"a.ply",
     two + "element face 1\nproperty int q\nend_header\n1 2 3\n4 5 6\n1\n",
     unreadable,
     {"element face", "vertex_indices"}},
    {"a.ply",
     two + "element face 1\n" + corners + "end_header\n1 2 3\n4 5 6\n3 0 1 2\n",
     unreadable,
     {"line 12, face 0", "vertex 2", "there are 2"}},
    {"a.ply",
     two + "element face 1\n" + corners + "end_header\n1 2 3\n4 5 6\n3 0 1 -1\n",
     unreadable,
     {"line 12, face 0", "vertex -1"}},
    {"a.ply",
     two + "element face 1\n" + corners + "end_header\n1 2 3\n4 5 6\n2 0 1\n",
     unreadable,
     {"face 0", "2 corners"}},
    {"a.ply",
     two + "element face 1\n" + corners + "end_header\n1 2 3\n4 5 6\n200 0 1\n",
     unreadable,
     {"face 0 of 1", "200 entries"}},
    {"a.ply",
     two + "element face 2\n" + corners + "end_header\n1 2 3\n4 5 6\n3 0 1 1",
     unreadable,
     {"face 1 of 2", "ends early"}},
    {"a.ply",
     two + "element face 99\n" + corners + "end_header\n1 2 3\n4 5 6\n3 0 1 1\n",
     unreadable,
     {"element face", "99 are declared"}},
    {"a.ply",
     binary + "element vertex 1\n" + xyz +
         "element face 1\nproperty list uchar int vertex_index\nend_header\n" + std::string(12, 0) +
         std::string("\3\0\0\0\0\0\0\0\0\7\0\0\0", 13),
     unreadable,
     {"face 0", "vertex 7", "there are 1"}},
    {"a.ply",
     binary + "element vertex 1\n" + xyz +
         "element face 1\nproperty list uchar float vertex_index\nend_header\n" +
         std::string(12, 0) + std::string("\3\0\0\0\0\0\0\0\0\0\0\0\x3F", 13),
     unreadable,
     {"face 0", "vertex 0.5"}},
    {"a.off", square + "3 0 1 3\n", unreadable, {"line 6, face 0", "vertex 3", "there are 3"}},
    {"a.off", square + "3 0 1 4294967295\n", unreadable, {"face 0", "vertex 4294967295"}},
    {"a.off", square + "3 0 1\n", unreadable, {"line 6, face 0", "'' is not a number"}},
    {"a.off", square + "9999999999 0 1\n", unreadable, {"line 6, face 0", "9999999999 corners"}},
    {"a.off", square + "-3 0 1 2\n", unreadable, {"line 6", "negative count"}},
    {"a.off", square, unreadable, {"1 faces are declared"}},
    {"a.off",
     square + "# no face, but a long comment\n",
     unreadable,
     {"face 0 of 1", "ends early"}},
    {"a.off", square + "3 0 1 2\n3 0 1 2\n", unreadable, {"line 7", "after the last"}},
    {"a.obj", obj, unreadable, {"no faces"}},
    {"a.obj",
     obj + "f 1 2 4\n",
     unreadable,
     {"line 4, face 0", "vertex 4", "there are 3, numbered from 1"}},
    {"a.obj", obj + "f 0 1 2\n", unreadable, {"line 4, face 0", "vertex 0", "numbered from 1"}},
    {"a.obj", obj + "f 1 2 3\nf -4 1 2\n", unreadable, {"line 5, face 1", "vertex -4", "only 3"}},
    {"a.obj", obj + "f 1 2 c/1\n", unreadable, {"line 4, face 0", "'c/1'"}},
    {"a.obj", obj + "f 1 2\n", unreadable, {"line 4, face 0", "2 corners"}},
    {"a.obj", obj + "f 1 2 99999999999999999999\n", unreadable, {"face 0", "99999999999999999999"}},
    {"a.stl", "solid", unreadable, {"before endsolid"}},
    {"a.stl", "soli", unreadable, {"neither"}},
    {"a.stl",
     "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\nendfacet\n",
     unreadable,
     {"line 6, triangle 0", "has 1 corners"}},
    {"a.stl", "solid a\nvertex 0 0 zero\n", unreadable, {"line 2, triangle 0", "'zero'"}},
    {"a.stl",
     "solid a\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 0 0\n",
     unreadable,
     {"line 5", "more than 3"}},
    {"a.stl", "solid a\ncolour red\n", unreadable, {"line 2", "'colour'"}},
    {"a.stl", "solid a\nfacet\nvertex 0 0 0\nendsolid\n", unreadable, {"line 4", "within a facet"}},
    {"a.stl", "solid a\nendsolid a\n", ErrorCode::bad_points, {"no vertices"}},
    {"a.stl",
     std::string(80, 'x') + std::string("\2\0\0\0", 4) + std::string(60, 'x'),
     unreadable,
     {"triangle 1 of 2", "ends early"}},
    {"a.stl",
     std::string(80, 'x') + std::string("\1\0\0\0", 4) + std::string(60, 'x'),
     unreadable,
     {"goes on after the 1"}},
};

TEST(ReadMesh, EveryFailureIsTypedAndNamesThePlace) {
  for (const Case& c : mesh_cases) {
    const auto result = mesh_of(c.file, c.bytes);
    expect(c, result.error(), !result);
  }
}

TEST(ReadPoints, NamesWhatIsWrongWithThePath) {
  const TempDirectory directory;
  const auto missing = read_points(directory.path("none.ply"));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, unreadable);
  EXPECT_NE(missing.error().message.find("No such file"), std::string::npos);
  const auto folder = read_points(directory.path(""));
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().code, unreadable);
  EXPECT_NE(folder.error().message.find("is a directory"), std::string::npos);
  ASSERT_EQ(mkfifo(directory.path("pipe.ply").c_str(), 0600), 0);
  const auto pipe = read_points(directory.path("pipe.ply"));
  ASSERT_FALSE(pipe);
  EXPECT_NE(pipe.error().message.find("not a regular file"), std::string::npos);
}

// The superuser may read everything, so becomes someone else for a while.
TEST(ReadPoints, NeedsThePermission) {
  const TempDirectory directory;
  const std::string path = directory.save("secret.xyz", "1 2 3\n");
  ASSERT_EQ(chmod(path.c_str(), 0), 0);
  constexpr uid_t nobody = 65534;
  const bool root = geteuid() == 0;
  if (root) {
    ASSERT_EQ(chmod(directory.path("").c_str(), 0755), 0);
    ASSERT_EQ(seteuid(nobody), 0);
  }
  const auto result = read_points(path);
  if (root) {
    ASSERT_EQ(seteuid(0), 0);
  }
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, unreadable);
  EXPECT_NE(result.error().message.find("Permission denied"), std::string::npos);
}

TEST(ReadPoints, RespectsTheMemoryLimit) {
  const TempDirectory directory;
  std::string rows;
  for (int k = 0; k < 1000; ++k) rows += "1 2 3\n";
  Context context;
  context.memory_limit = 20000;  // more than the file, less than 1000 points of 24 bytes
  for (const auto& [name, start] : {std::pair<const char*, std::string>{"a.xyz", ""},
                                    {"a.ply", ply + "element vertex 1000\n" + xyz + "end_header\n"},
                                    {"a.off", "OFF\n1000 0 0\n"}}) {
    const auto result = read_points(directory.save(name, start + rows), context);
    ASSERT_FALSE(result) << name;
    EXPECT_EQ(result.error().code, ErrorCode::out_of_memory) << result.error().message;
    EXPECT_NE(result.error().message.find("1000"), std::string::npos) << result.error().message;
  }
  context.memory_limit = 100;
  const auto large = read_points(directory.path("a.xyz"), context);
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().code, ErrorCode::out_of_memory);
}

TEST(ReadPoints, CanBeCancelledWhileItReads) {
  const TempDirectory directory;
  std::string text;
  for (int k = 0; k < 50000; ++k) text += "1 2 3\n";
  const std::string path = directory.save("a.xyz", text);
  std::atomic<bool> cancel = false;
  Context context;
  context.cancel = &cancel;
  context.progress = [&](std::string_view stage, double fraction) {
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    if (stage == "parse") cancel = true;
  };
  const auto result = read_points(path, context);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace arris::test
