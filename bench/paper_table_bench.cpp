// Table 1 of the paper on clouds given as files: the same columns, with our times.
//
//   paper_table_bench CLOUD.ply ...
#include <arris/arris.h>

#include <cstdio>
#include <string>

namespace {

std::string base_name(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return path.substr(slash == std::string::npos ? 0 : slash + 1);
}

void print_row(const std::string& name, const arris::Report& report) {
  double mesh = 0, cuts = 0, swaps = 0;
  for (const arris::StageReport& stage : report.stages) {
    if (stage.name == "delaunay" || stage.name == "seeds" || stage.name == "background")
      mesh += stage.seconds;
    if (stage.name.starts_with("cut")) cuts += stage.seconds;
    if (stage.name == "swap") swaps += stage.seconds;
  }
  std::printf("| %s | %llu | %.2f | %llu | %zu | %.2f | %zu | %.2f |\n", name.c_str(),
              static_cast<unsigned long long>(report.samples), mesh,
              static_cast<unsigned long long>(report.tetrahedra), report.cut_energy.size(), cuts,
              report.swap_energy.empty() ? 0 : report.swap_energy.size() - 1, swaps);
}

}  // namespace

int main(int argc, char** argv) {
  std::printf(
      "| Example | Data set | Mesh generation, s | Tetrahedra | Global cycles | Graph cuts, s | "
      "Local cycles | Swap, s |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  arris::Options options;
  options.method = arris::Method::paper;
  int failures = 0;
  for (int i = 1; i < argc; ++i) {
    const auto cloud = arris::read_points(argv[i]);
    const auto result = cloud ? arris::reconstruct(*cloud, options)
                              : arris::Result<arris::Reconstruction>(cloud.error());
    if (!result) {
      std::fprintf(stderr, "%s: %s\n", argv[i], result.error().message.c_str());
      ++failures;
      continue;
    }
    print_row(base_name(argv[i]), result->report);
  }
  return failures > 0;
}
