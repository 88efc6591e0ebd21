#include "truth/models.h"

#include <numbers>
#include <stdexcept>

#include "base/vec.h"
#include "truth/measure.h"
#include "truth/paper_models.h"
#include "truth/revolution.h"
#include "truth/shapes.h"

namespace arris::truth {
namespace {

constexpr double pi = std::numbers::pi;

// A flat solid of shapes.h, which has no resolution.
template <Shape (*shape)()>
Mesh flat(int) {
  return shape().mesh;
}

template <Mesh (*make)()>
Mesh flat(int) {
  return make();
}

// The curved solids of shapes.h at any resolution.
Mesh ball(int n) {
  return revolve(arc(0, 0, 1, -pi / 2, pi / 2, n / 2), n);
}

Mesh ring(int n) {
  return revolve_loop(arc(1, 0, 0.4, 0, 2 * pi, n / 2), n);
}

Mesh round_bar(int n) {
  return revolve({{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}, n);
}

Mesh round_cone(int n) {
  return revolve({{0, 0}, {0.5, 0}, {0, 1}}, n);
}

}  // namespace

const std::vector<ModelEntry>& models() {
  static const std::vector<ModelEntry> all = {
      {"two_cubes", "two unit cubes that overlap in an eighth", flat<two_cubes>},
      {"two_spheres", "two overlapping balls", two_spheres},
      {"perforated_cube", "a cube with a square tunnel along every axis", flat<perforated_cube>},
      {"tangled_cubes", "two perforated cubes, interlocked", flat<tangled_frames>},
      {"male_symbol", "a flat ring, a bar and an arrow head", male_symbol},
      {"female_symbol", "a torus and a cross of round bars", female_symbol},
      {"dodecahedron", "twelve regular pentagons", flat<dodecahedron>},
      {"icosahedron", "twenty regular triangles", flat<icosahedron>},
      {"buckyball", "a truncated icosahedron", flat<buckyball>},
      {"brilliant_diamond", "a round brilliant cut; some edges turn by 12 degrees only",
       flat<brilliant_diamond>},
      {"power_wheel", "a wheel with ten teeth, grooves and a bored hub", power_wheel},
      {"tear_drop", "smooth but for its tip", tear_drop},
      {"dumb_bell", "two balls on a bar", dumb_bell},
      {"bolt", "a hexagonal head and a threaded shank", bolt},
      {"cube", "a unit cube", flat<cube>},
      {"sphere", "a ball of radius 1", ball},
      {"cylinder", "radius 0.5, height 1", round_bar},
      {"cone", "radius 0.5, height 1", round_cone},
      {"torus", "radii 1 and 0.4", ring},
      {"thin_plate", "1 x 1 x 0.05", flat<thin_plate>},
      {"wedge", "a prism whose sharpest edge has 27 degrees", flat<wedge>},
      {"l_bracket", "an L of square arms", flat<l_bracket>},
      {"drilled_bracket", "an L of two plates with two round holes in each", drilled_bracket},
      {"nested_shells", "a cube in the void of a cube", flat<nested_shells>},
      {"steps", "a staircase of three steps", flat<steps>},
      {"octahedron", "eight regular triangles", flat<octahedron>},
      {"hexagonal_prism", "a regular hexagon extruded", flat<hexagonal_prism>},
  };
  return all;
}

Mesh make_model(std::string_view name, int resolution) {
  if (resolution < lowest_resolution || resolution > highest_resolution)
    throw std::invalid_argument("the resolution is out of range");
  for (const ModelEntry& model : models())
    if (model.name == name) return model.make(resolution);
  throw std::out_of_range("no model has that name");
}

Mesh to_unit_diagonal(Mesh mesh) {
  const Bounds bounds = bounds_of(mesh.vertices);
  const double scale = 1 / bounds.diagonal();
  for (Vec3& p : mesh.vertices) p = scale * (p - bounds.centre());
  return mesh;
}

}  // namespace arris::truth
