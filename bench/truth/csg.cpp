#include "truth/csg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/vec.h"
#include "truth/boolean.h"
#include "truth/measure.h"
#include "truth/random.h"
#include "truth/revolution.h"
#include "truth/samplers.h"
#include "truth/shapes.h"

namespace arris::truth {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double thinnest_part = 0.04;  // of the diagonal
constexpr double least_change = 0.02;   // of the volume, by every step

struct Primitive {
  const char* name;
  Mesh mesh;  // about 1 across, round the origin
};

std::vector<Vec3> extruded(const std::vector<Vec3>& base, double height) {
  std::vector<Vec3> points;
  for (const double z : {-height / 2, height / 2})
    for (const Vec3 p : base) points.push_back({p.x, p.y, z});
  return points;
}

// A bar round the z axis with radii at both ends; a radius of 0 is a tip.
Mesh turned(double low_radius, double high_radius, double height, int around) {
  const double h = height / 2;
  std::vector<ProfilePoint> profile = {{0, -h}, {low_radius, -h}};
  if (high_radius > 0) profile.push_back({high_radius, h});
  profile.push_back({0, h});
  return revolve(profile, around);
}

Primitive draw_primitive(Random& random, int resolution) {
  const double a = random.between(0.3, 0.6), b = random.between(0.35, 1),
               c = random.between(0.3, 1);
  const int sides = 3 + static_cast<int>(random.below(6));
  switch (random.below(8)) {
    case 0:
      return {"box", convex_hull(extruded({{-a, -b, 0}, {a, -b, 0}, {a, b, 0}, {-a, b, 0}}, c))};
    case 1:
      return {"prism", turned(a, a, 0.5 + c, sides)};
    case 2:
      return {"pyramid", turned(a + 0.2, 0, 0.5 + c, sides)};
    case 3:
      return {"cylinder", turned(0.5 * a, 0.5 * a, 0.5 + 2 * c, resolution)};
    case 4:
      return {"cone", turned(a, 0, 0.5 + c, resolution)};
    case 5:
      return {"frustum", turned(a, 0.5 * a, 0.5 + c, resolution)};
    case 6:
      return {"sphere", revolve(arc(0, 0, a, -pi / 2, pi / 2, resolution / 2), resolution)};
    default:
      return {"wedge", convex_hull(extruded({{-a, -b / 2, 0}, {a, -b / 2, 0}, {-a, b, 0}}, c))};
  }
}

// Long enough to go through.
Primitive draw_drill(Random& random, int resolution) {
  const double radius = random.between(0.12, 0.25);
  const int sides = 3 + static_cast<int>(random.below(4));
  if (random.below(2) == 0) return {"round hole", turned(radius, radius, 6, resolution)};
  return {"hole", turned(radius, radius, 6, sides)};
}

// One step of a recipe: what is done, with a primitive of what size, how far from the surface.
struct Step {
  Operation operation;
  const char* sign;
  double size, offset;
  bool drill = false;  // a long bar instead of any primitive
};

Step draw_step(Random& random) {
  constexpr std::array<Step, 12> steps = {{
      {Operation::unite, " + ", 1, 0.2},
      {Operation::unite, " + ", 1, 0.2},
      {Operation::unite, " + ", 0.7, 0.1},
      {Operation::unite, " + ", 0.7, 1.5},  // beside it
      {Operation::subtract, " - ", 1, 0.2},
      {Operation::subtract, " - ", 0.7, 0.3},
      {Operation::subtract, " - ", 0.7, 0.3},
      {Operation::subtract, " - ", 0.5, 0.5},
      {Operation::subtract, " - ", 0.4, 0.6},  // perhaps a void inside
      {Operation::subtract, " - ", 1, 0.2, true},
      {Operation::subtract, " - ", 1, 0.2, true},
      {Operation::intersect, " & ", 2, 0.3},
  }};
  return steps.at(random.below(steps.size()));
}

// The primitive scaled, turned, and put near a point of the surface.
Mesh pose(const Mesh& primitive, const Mesh& solid, const Step& step, Random& random) {
  const Vec3 on_surface = sample(solid, {Mode::uniform, 1, random.next()}).positions[0];
  const Vec3 at = on_surface + (step.offset * random.unit()) * random.direction();
  return moved(primitive, random.next(), step.size, at);
}

// Is the step worth taking, and can its result be sampled and represented?
bool acceptable(const Mesh& before, const Mesh& after, Thickness& thickness) {
  if (after.triangles.empty()) return false;
  const double change = std::abs(volume(after) - volume(before));
  if (change < least_change * std::max(volume(before), volume(after))) return false;
  const double diagonal = bounds_of(after.vertices).diagonal();
  if (has_thin_spots(after, thinnest_part * diagonal)) return false;
  thickness = measure_thickness(after);
  return thickness.thinnest() >= thinnest_part * diagonal;
}

}  // namespace

CsgModel random_csg(std::uint64_t seed, int resolution) {
  constexpr int most_draws = 40;  // for one step; then the model is done without it
  Random random(seed);
  Primitive first = draw_primitive(random, resolution);
  CsgModel model;
  model.mesh = moved(std::move(first.mesh), random.next());
  model.recipe = first.name;
  model.thickness = measure_thickness(model.mesh);
  const int steps = 1 + static_cast<int>(random.below(5));
  for (int i = 0; i < steps; ++i) {
    for (int draw = 0; draw < most_draws; ++draw) {
      const Step step = draw_step(random);
      const Primitive primitive =
          step.drill ? draw_drill(random, resolution) : draw_primitive(random, resolution);
      const Mesh tool = pose(primitive.mesh, model.mesh, step, random);
      std::optional<Mesh> result = combine(model.mesh, tool, step.operation);
      Thickness thickness;
      if (!result || !acceptable(model.mesh, *result, thickness)) {
        ++model.retries;
        continue;
      }
      model.mesh = *std::move(result);
      model.thickness = thickness;
      model.recipe += step.sign;
      model.recipe += primitive.name;
      break;
    }
  }
  return model;
}

}  // namespace arris::truth
