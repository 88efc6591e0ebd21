// Writes the pairs as files, for evaluators: make_pairs DIRECTORY
#include <cstdio>
#include <string>
#include <utility>

#include "arris/io.h"
#include "compare/pairs.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_pairs DIRECTORY\n");
    return 2;
  }
  for (const arris::test::Pair& pair : arris::test::comparison_pairs())
    for (const auto& [part, mesh] : {std::pair{"result", &pair.result}, {"truth", &pair.truth}}) {
      const std::string path = std::string(argv[1]) + "/" + pair.name + "." + part + ".ply";
      if (const auto written = arris::write_mesh(path, *mesh); !written) {
        std::fprintf(stderr, "%s\n", written.error().message.c_str());
        return 1;
      }
    }
  return 0;
}
