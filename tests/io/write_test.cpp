#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <sstream>

#include "io/atomic_file.h"
#include "support.h"

namespace arris::test {
namespace {

using Names = std::vector<std::string>;

// A mesh of random triangles in which every vertex is used, in order of first use.
Mesh random_mesh(ScalarType position_type, std::mt19937_64& random) {
  PointCloud cloud = random_cloud(3 + random() % 20, position_type, random);
  Mesh mesh;
  mesh.vertices = std::move(cloud.positions);
  mesh.attributes = std::move(cloud.attributes);
  mesh.position_type = position_type;
  const auto n = static_cast<Index>(mesh.vertices.size());
  for (Index v = 0; v + 2 < n; ++v) mesh.triangles.push_back({v, v + 1, v + 2});
  for (const char* name : {"support", "filled", "patch"}) {
    if (random() % 2) continue;
    mesh.face_attributes.push_back({name, random_type(random), {}});
    for (Index v = 0; v + 2 < n; ++v)
      mesh.face_attributes.back().values.push_back(
          random_value(mesh.face_attributes.back().type, random));
  }
  return mesh;
}

// OBJ has the faces in the order of their groups.
std::vector<Triangle> in_any_order(std::vector<Triangle> triangles) {
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

Mesh tetrahedron() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return mesh;
}

RC_GTEST_PROP(WriteMesh, ReadsBackExactly, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const Mesh mesh = random_mesh(random() % 2 ? ScalarType::f32 : ScalarType::f64, random);
  const std::string extension = *rc::gen::element<std::string>(".ply", ".off", ".obj", ".STL");
  const TempDirectory directory;
  const std::string path = directory.path("mesh" + extension);
  RC_ASSERT(static_cast<bool>(write_mesh(path, mesh)));
  const auto read = read_mesh(path);
  RC_ASSERT(static_cast<bool>(read));
  RC_ASSERT(same(read->vertices, mesh.vertices));
  RC_ASSERT(in_any_order(read->triangles) == in_any_order(mesh.triangles));
  if (extension == ".ply") {
    RC_ASSERT(read->triangles == mesh.triangles);
    RC_ASSERT(same(read->face_attributes, mesh.face_attributes));
    RC_ASSERT(same(read->attributes, mesh.attributes));
    RC_ASSERT(read->position_type == mesh.position_type);
    const auto cloud = read_points(path);
    RC_ASSERT(static_cast<bool>(cloud));
    RC_ASSERT(same(cloud->positions, mesh.vertices));
  }
  RC_ASSERT(directory.entries() == Names{"mesh" + extension});
}

TEST(WriteMesh, PlyHoldsFloatsOnlyWhereTheyAreExact) {
  const TempDirectory directory;
  Mesh mesh = tetrahedron();
  mesh.position_type = ScalarType::f32;
  ASSERT_TRUE(write_mesh(directory.path("a.ply"), mesh));
  EXPECT_NE(directory.load("a.ply").find("property float x"), std::string::npos);
  mesh.vertices[3].z = 0.1;
  ASSERT_TRUE(write_mesh(directory.path("a.ply"), mesh));
  EXPECT_NE(directory.load("a.ply").find("property double x"), std::string::npos);
}

TEST(WriteMesh, PlyBendsNamesAndValuesThatDoNotFit) {
  const TempDirectory directory;
  Mesh mesh = tetrahedron();
  mesh.attributes = {{"x", ScalarType::u8, {-1, 300, NAN, 2.6}},
                     {"scan id", ScalarType::f32, {1e300, -1e300, HUGE_VAL, 0.5}},
                     {"scan_id", ScalarType::i8, {-1e9, 1e9, 1, -0.4}}};
  ASSERT_TRUE(write_mesh(directory.path("a.ply"), mesh));
  const auto read = read_mesh(directory.path("a.ply"));
  ASSERT_TRUE(read) << read.error().message;
  constexpr double high = std::numeric_limits<float>::max();
  const std::vector<Attribute> expected = {
      {"x_", ScalarType::u8, {0, 255, 0, 3}},
      {"scan_id", ScalarType::f32, {high, -high, HUGE_VAL, 0.5}},
      {"scan_id_", ScalarType::i8, {-128, 127, 1, 0}}};
  EXPECT_EQ(read->attributes, expected);
}

TEST(WriteMesh, ObjCarriesColours) {
  const TempDirectory directory;
  Mesh mesh = tetrahedron();
  for (const char* name : {"red", "green", "blue"})
    mesh.attributes.push_back({name, ScalarType::u8, {0, 1, 77, 255}});
  ASSERT_TRUE(write_mesh(directory.path("a.obj"), mesh));
  const auto read = read_mesh(directory.path("a.obj"));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->attributes, mesh.attributes);
}

TEST(WriteMesh, StlIsBinaryOnlyIfThatIsExact) {
  const TempDirectory directory;
  Mesh mesh = tetrahedron();
  ASSERT_TRUE(write_mesh(directory.path("a.stl"), mesh));
  const std::string binary = directory.load("a.stl");
  EXPECT_EQ(binary.size(), 84u + 4 * 50);
  EXPECT_FALSE(binary.starts_with("solid"));
  mesh.vertices[3].z = 1e-300;  // tiny: its normals must not vanish
  ASSERT_TRUE(write_mesh(directory.path("a.stl"), mesh));
  const std::string ascii = directory.load("a.stl");
  EXPECT_TRUE(ascii.starts_with("solid"));
  EXPECT_NE(ascii.find("facet normal 0 0 -1\n"), std::string::npos) << ascii;
  EXPECT_NE(ascii.find("vertex 0 0 1e-300\n"), std::string::npos);
}

TEST(WriteMesh, StlNormalsAreUnitAndOutward) {
  const TempDirectory directory;
  ASSERT_TRUE(write_mesh(directory.path("a.stl"), tetrahedron()));
  const std::string bytes = directory.load("a.stl");
  float normal[3];
  std::memcpy(normal, bytes.data() + 84 + 2 * 50, sizeof normal);  // the slanted triangle
  for (const float c : normal) EXPECT_FLOAT_EQ(c, 1 / std::sqrt(3.f));
}

TEST(WriteMesh, RefusesInconsistentMeshes) {
  const TempDirectory directory;
  Mesh mesh = tetrahedron();
  mesh.attributes = {{"q", ScalarType::u8, {1}}};
  const auto attribute = write_mesh(directory.path("a.ply"), mesh);
  ASSERT_FALSE(attribute);
  EXPECT_EQ(attribute.error().code, ErrorCode::usage);
  mesh = tetrahedron();
  mesh.triangles[2][1] = 4;
  for (const char* name : {"a.ply", "a.off", "a.obj", "a.stl"}) {
    const auto index = write_mesh(directory.path(name), mesh);
    ASSERT_FALSE(index);
    EXPECT_EQ(index.error().code, ErrorCode::usage);
    EXPECT_NE(index.error().message.find("element 2 names vertex 4"), std::string::npos);
  }
  EXPECT_TRUE(directory.entries().empty());
}

TEST(WriteMesh, RefusesUnknownExtensions) {
  const TempDirectory directory;
  for (const char* name : {"a.xyz", "a", ".ply"}) {
    const auto result = write_mesh(directory.path(name), tetrahedron());
    ASSERT_FALSE(result) << name;
    EXPECT_EQ(result.error().code, ErrorCode::unsupported);
  }
  const auto volume = write_tetrahedra(directory.path("a.ply"), {});
  ASSERT_FALSE(volume);
  EXPECT_EQ(volume.error().code, ErrorCode::unsupported);
}

TetVolume one_tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}}, {{0, 1, 2, 3}}};
}

TEST(WriteTetrahedra, Gmsh) {
  const TempDirectory directory;
  ASSERT_TRUE(write_tetrahedra(directory.path("a.msh"), one_tetrahedron()));
  EXPECT_EQ(directory.load("a.msh"),
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"
            "4 0 0 0.1\n$EndNodes\n$Elements\n1\n1 4 2 1 1 1 2 3 4\n$EndElements\n");
}

TEST(WriteTetrahedra, Vtk) {
  const TempDirectory directory;
  ASSERT_TRUE(write_tetrahedra(directory.path("a.vtk"), one_tetrahedron()));
  EXPECT_EQ(directory.load("a.vtk"),
            "# vtk DataFile Version 3.0\ntetrahedra by arris\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            "POINTS 4 double\n0 0 0\n1 0 0\n0 1 0\n0 0 0.1\nCELLS 1 5\n4 0 1 2 3\n"
            "CELL_TYPES 1\n10\n");
}

TEST(WriteText, ReplacesTheTargetAndKeepsItsMode) {
  const TempDirectory directory;
  const std::string path = directory.save("a.txt", "old");
  ASSERT_EQ(chmod(path.c_str(), 0640), 0);
  std::filesystem::create_symlink("a.txt", directory.path("link"));
  ASSERT_TRUE(write_text(directory.path("link"), "new"));
  EXPECT_EQ(directory.load("a.txt"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(directory.path("link")));
  struct stat info {};
  ASSERT_EQ(stat(path.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777u, 0640u);
  EXPECT_EQ(directory.entries(), (Names{"a.txt", "link"}));
}

void expect_unwritable(const Result<void>& result, const std::string& reason) {
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::unwritable);
  EXPECT_NE(result.error().message.find(reason), std::string::npos) << result.error().message;
  EXPECT_FALSE(result.error().remedy.empty());
}

TEST(WriteText, NamesWhyItCannotWrite) {
  const TempDirectory directory;
  directory.save("file", "");
  expect_unwritable(write_text(directory.path("none/a.txt"), "a"), "No such file or directory");
  expect_unwritable(write_text(directory.path("file/a.txt"), "a"), "Not a directory");
  expect_unwritable(write_text(directory.path(""), "a"), "Is a directory");
  expect_unwritable(write_text("/dev/full", "a"), "No space left on device");
  EXPECT_EQ(directory.entries(), Names{"file"});
}

TEST(WriteText, NeedsThePermission) {
  const TempDirectory directory;
  directory.save("mine.txt", "old");
  constexpr uid_t nobody = 65534;
  const bool root = geteuid() == 0;
  ASSERT_EQ(chmod(directory.path("").c_str(), root ? 0755 : 0555), 0);
  if (root) {
    ASSERT_EQ(seteuid(nobody), 0);
  }
  const auto create = write_text(directory.path("new.txt"), "a");
  if (root) {
    ASSERT_EQ(seteuid(0), 0);
  }
  ASSERT_EQ(chmod(directory.path("").c_str(), 0755), 0);
  expect_unwritable(create, "Permission denied");
  EXPECT_EQ(directory.entries(), Names{"mine.txt"});
}

// A limit on the size of files stands for a full disk: the write fails half way.
TEST(WriteMesh, AFailedWriteLeavesTheTargetAlone) {
  const TempDirectory directory;
  directory.save("a.off", "old");
  Mesh mesh = tetrahedron();
  mesh.triangles.resize(200000, mesh.triangles[0]);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 1 << 20;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto result = write_mesh(directory.path("a.off"), mesh);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  expect_unwritable(result, "File too large");
  EXPECT_EQ(directory.load("a.off"), "old");
  EXPECT_EQ(directory.entries(), Names{"a.off"});
}

TEST(WriteMesh, ACancelledWriteLeavesNothingBehind) {
  const TempDirectory directory;
  directory.save("a.off", "old");
  std::atomic<bool> cancel = false;
  Context context;
  context.cancel = &cancel;
  bool seen_temporary = false;
  context.progress = [&](std::string_view, double fraction) {
    if (fraction < 1) return;
    seen_temporary = directory.entries().size() == 2;  // at the very end, before the rename
    cancel = true;
  };
  Mesh mesh = tetrahedron();
  ASSERT_TRUE(write_mesh(directory.path("a.off"), mesh, context));  // too late to cancel
  EXPECT_TRUE(seen_temporary);
  directory.save("a.off", "old");
  cancel = false;
  mesh.triangles.resize(200000, mesh.triangles[0]);
  context.progress = [&](std::string_view, double) { cancel = true; };
  const auto result = write_mesh(directory.path("a.off"), mesh, context);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::cancelled);
  EXPECT_EQ(directory.load("a.off"), "old");
  EXPECT_EQ(directory.entries(), Names{"a.off"});
}

TEST(AtomicFile, WritersOfOneTargetDoNotMeet) {
  const TempDirectory directory;
  AtomicFile first(directory.path("a.txt")), second(directory.path("a.txt"));
  first.text("first");
  second.text("second");
  second.commit();
  EXPECT_EQ(directory.load("a.txt"), "second");
  first.commit();
  EXPECT_EQ(directory.load("a.txt"), "first");
  EXPECT_EQ(directory.entries(), Names{"a.txt"});
}

}  // namespace
}  // namespace arris::test
