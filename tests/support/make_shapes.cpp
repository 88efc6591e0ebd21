// Writes samples of solids made by code, to try the command on: make_shapes DIRECTORY SAMPLER
// SAMPLES NAME... writes DIRECTORY/NAME.ply for each. SAMPLER: uniform, blue (evenly spread), or
// feature (corners and sharp edges first). Names are those of tests/support/shapes.h.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "arris/arris.h"
#include "support/samplers.h"
#include "support/shapes.h"

namespace {

using namespace arris;

constexpr std::uint64_t seed = 1;

std::vector<Vec3> sample(std::string_view sampler, const Mesh& mesh, std::size_t n) {
  if (sampler == "uniform") return test::sample_uniform(mesh, n, seed);
  if (sampler == "blue") return test::sample_blue(mesh, n, seed);
  if (sampler == "feature") return test::sample_feature(mesh, n, seed);
  throw std::out_of_range("no sampler is called that");
}

// A mesh without faces is written as its points.
void write_samples(const std::string& path, std::string_view sampler, std::size_t n,
                   std::string_view name) {
  Mesh cloud;
  cloud.vertices = sample(sampler, test::make_shape(name).mesh, n);
  if (const Result<void> written = write_mesh(path, cloud); !written)
    throw std::runtime_error(written.error().message);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fprintf(stderr, "usage: make_shapes DIRECTORY SAMPLER SAMPLES NAME...\n");
    return 2;
  }
  const std::string directory = argv[1], sampler = argv[2];
  const std::size_t n = std::strtoul(argv[3], nullptr, 10);
  try {
    for (int k = 4; k < argc; ++k)
      write_samples(directory + "/" + argv[k] + ".ply", sampler, n, argv[k]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "make_shapes: %s\n", e.what());
    return 1;
  }
}
