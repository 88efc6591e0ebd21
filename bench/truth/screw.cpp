// The bolt: a threaded rod cut to a shank with chamfered ends, united with a hexagonal head.
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "base/vec.h"
#include "truth/boolean.h"
#include "truth/must.h"
#include "truth/paper_models.h"
#include "truth/revolution.h"

namespace arris::truth {
namespace {

constexpr double pi = std::numbers::pi;

Mesh revolve_turned(const std::vector<ProfilePoint>& profile, int resolution, double steps) {
  return turned_about_z(revolve(profile, resolution), 2 * pi * steps / resolution);
}

}  // namespace

// Row j runs once round along root (j even) or crest (j odd), climbing by a pitch; its end is the
// start of row j + 2. The first two rows and the last two are closed with fans from the axis.
Mesh threaded_rod(double root, double crest, double pitch, double length, int resolution) {
  const auto around = static_cast<Index>(resolution);
  const auto rows = static_cast<Index>(2 * (std::ceil(length / pitch) + 3));
  Mesh mesh;
  const auto add_vertex = [&](Index row, Index i) {
    const double turns = static_cast<double>(i) / resolution, angle = 2 * pi * turns;
    const double r = row % 2 == 0 ? root : crest;
    const double z = pitch * (0.5 * row + turns - 2);
    mesh.vertices.push_back({r * std::cos(angle), r * std::sin(angle), z});
  };
  for (Index row = 0; row < rows; ++row)
    for (Index i = 0; i < around; ++i) add_vertex(row, i);
  for (const Index row : {rows, rows + 1}) add_vertex(row, 0);  // where the last two rows end
  const auto at = [&](Index row, Index i) {
    if (i == around) row += 2, i = 0;
    return row < rows ? row * around + i : rows * around + (row - rows);
  };
  for (Index row = 0; row + 1 < rows; ++row)
    for (Index i = 0; i < around; ++i) {
      mesh.triangles.push_back({at(row, i), at(row, i + 1), at(row + 1, i + 1)});
      mesh.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row + 1, i)});
    }
  const auto bottom = static_cast<Index>(mesh.vertices.size()), top = bottom + 1;
  mesh.vertices.push_back({0, 0, -3 * pitch});
  mesh.vertices.push_back({0, 0, pitch * (0.5 * rows - 1)});
  // The rims: row 0 and back down the seam; the last row and up the seam.
  for (Index i = 0; i < around; ++i) {
    mesh.triangles.push_back({bottom, at(0, i + 1), at(0, i)});
    mesh.triangles.push_back({top, at(rows - 1, i), at(rows - 1, i + 1)});
  }
  for (const Index row : {Index{0}, Index{1}}) {
    mesh.triangles.push_back({bottom, at(row, 0), at(row + 1, 0)});
    mesh.triangles.push_back({top, at(rows + row, 0), at(rows - 1 + row, 0)});
  }
  return mesh;
}

Mesh bolt(int resolution) {
  constexpr double root = 0.42, crest = 0.5, pitch = 0.2;
  constexpr double shank = 2.6, plain = 0.6, head = 0.65;  // lengths along the axis
  constexpr double chamfer = 0.1;
  // The thread, cut flat with a chamfer below and where the plain part of the shank begins.
  const double threaded = shank - plain;
  const Mesh envelope = revolve_turned({{0, 0},
                                        {root - 0.02, 0},
                                        {crest + chamfer, chamfer + 0.02},
                                        {crest + chamfer, threaded + 0.01},
                                        {0, threaded + 0.01}},
                                       resolution, 0.31);
  const Mesh thread = must(combine(threaded_rod(root, crest, pitch, threaded, resolution), envelope,
                                   Operation::intersect));
  const double r = 0.51;  // clear of the crests, so that no surfaces coincide
  const Mesh stem = revolve_turned(
      {{0, threaded}, {r, threaded}, {r, shank + 0.1}, {0, shank + 0.1}}, resolution, 0.57);
  // A hexagonal prism, its upper corners taken off by a cone.
  const double wide = 0.95, flat = wide * std::cos(pi / 6);
  const Mesh prism =
      revolve({{0, shank}, {wide, shank}, {wide, shank + head}, {0, shank + head}}, 6);
  const double above = shank + head + 0.2;
  const Mesh cone = revolve_turned({{0, shank - 1},
                                    {wide + 1, shank - 1},
                                    {flat + 0.3, shank + head - 0.18},
                                    {flat - 0.05, shank + head + 0.02},
                                    {flat - 0.05, above},
                                    {0, above}},
                                   resolution, 0.43);
  const Mesh cap = must(combine(prism, cone, Operation::intersect));
  return must(combine(must(combine(thread, stem, Operation::unite)), cap, Operation::unite));
}

}  // namespace arris::truth
