// The whole job in five lines: minimal scan.ply mesh.ply
#include <arris/arris.h>

#include <cstdio>

namespace {

int fail(const arris::Error& error) {
  std::fprintf(stderr, "%s (%s)\n", error.message.c_str(), error.remedy.c_str());
  return static_cast<int>(error.code);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: minimal POINTS MESH\n"), 2;
  const auto cloud = arris::read_points(argv[1]);
  if (!cloud) return fail(cloud.error());
  const auto result = arris::reconstruct(*cloud);
  if (!result) return fail(result.error());
  const auto written = arris::write_mesh(argv[2], result->mesh);
  return written ? 0 : fail(written.error());
}
