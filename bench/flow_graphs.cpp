#include "flow_graphs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "base/parallel.h"
#include "base/vec.h"
#include "energy/distance.h"
#include "tetra/delaunay.h"

namespace arris {
namespace {

using Random = std::mt19937_64;

// Relative to the local spacing: noise as of a good scanner; balls that must lie off the surface.
constexpr double noise_in_spacings = 0.25;
constexpr double seed_radius_in_spacings = 1.5, sparse_seed_radius_in_spacings = 8;
constexpr double outlier_share = 0.01;
constexpr double wrong_seed_share = 0.03;
constexpr double wrong_preference_share = 0.2;
// Capacity of a facet of unit cost d S / h^3: about 20 bits for the largest of interest.
constexpr double capacity_unit = 65536;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Vec3 on_unit_sphere(Random& random) {
  const double z = uniform(random, -1, 1), angle = uniform(random, 0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

double bumpy_radius(Vec3 direction) {
  return 1 +
         0.08 * std::sin(7 * direction.x) * std::sin(6 * direction.y) * std::cos(5 * direction.z);
}

// A plate 2 x 2 x 0.5 with four round holes of radius hole_radius through it.
constexpr Vec3 plate{1, 1, 0.25};
constexpr double hole_radius = 0.3, hole_centre = 0.5, torus_tube = 0.35;

bool in_hole(double x, double y) {
  return std::hypot(std::abs(x) - hole_centre, std::abs(y) - hole_centre) < hole_radius;
}

Vec3 on_plate(Random& random) {
  const double broad = 8, sides = 4, holes = 4 * 2 * std::numbers::pi * hole_radius * 0.5;
  while (true) {
    const double x = uniform(random, -1, 1), y = uniform(random, -1, 1);
    const double pick = uniform(random, 0, broad + sides + holes);
    const double z = uniform(random, -plate.z, plate.z);
    if (pick < broad) {
      if (!in_hole(x, y)) return {x, y, std::copysign(plate.z, z)};
    } else if (pick < broad + sides) {
      return pick < broad + sides / 2 ? Vec3{x, std::copysign(1.0, y), z}
                                      : Vec3{std::copysign(1.0, x), y, z};
    } else {
      const double angle = uniform(random, 0, 2 * std::numbers::pi);
      return {std::copysign(hole_centre, x) + hole_radius * std::cos(angle),
              std::copysign(hole_centre, y) + hole_radius * std::sin(angle), z};
    }
  }
}

Vec3 on_surface(Shape shape, Random& random) {
  if (shape == Shape::box_with_holes) return on_plate(random);
  if (shape == Shape::bumpy_sphere) {
    const Vec3 direction = on_unit_sphere(random);
    return bumpy_radius(direction) * direction;
  }
  const double u = uniform(random, 0, 2 * std::numbers::pi);
  const double v = uniform(random, 0, 2 * std::numbers::pi);
  const double r = 1 + torus_tube * std::cos(v);
  return {r * std::cos(u), r * std::sin(u), torus_tube * std::sin(v)};
}

bool is_inside(Shape shape, Vec3 p) {
  switch (shape) {
    case Shape::bumpy_sphere:
      return length(p) < bumpy_radius(1 / length(p) * p);
    case Shape::torus:
      return std::hypot(std::hypot(p.x, p.y) - 1, p.z) < torus_tube;
    case Shape::box_with_holes:
      return std::abs(p.x) < plate.x && std::abs(p.y) < plate.y && std::abs(p.z) < plate.z &&
             !in_hole(p.x, p.y);
  }
  return false;
}

double surface_area(Shape shape) {
  constexpr double pi = std::numbers::pi;
  if (shape == Shape::bumpy_sphere) return 4 * pi;
  if (shape == Shape::torus) return 4 * pi * pi * torus_tube;
  return 8 + 4 + 4 * (pi * hole_radius - 2 * pi * hole_radius * hole_radius);
}

std::vector<Vec3> sample(const Scene& scene, std::size_t count, double spacing, Random& random) {
  std::vector<Vec3> points(count);
  std::normal_distribution<double> normal(0, noise_in_spacings * spacing);
  for (Vec3& p : points) {
    p = on_surface(scene.shape, random);
    if (scene.flaw == Flaw::noise) p = p + Vec3{normal(random), normal(random), normal(random)};
    if (scene.flaw == Flaw::outliers && uniform(random, 0, 1) < outlier_share)
      p = {uniform(random, -1.5, 1.5), uniform(random, -1.5, 1.5), uniform(random, -1.5, 1.5)};
  }
  std::sort(points.begin(), points.end(), lexicographic_less);
  return points;
}

// Circumcentre; far away for a sliver, which then counts as big, as it does in practice.
Vec3 circumcentre(const TetMesh& mesh, Tet t) {
  const auto& v = mesh.vertices[t];
  const Vec3 o = mesh.points[v[0]];
  const Vec3 a = mesh.points[v[1]] - o, b = mesh.points[v[2]] - o, c = mesh.points[v[3]] - o;
  const Vec3 sum = squared_length(a) * cross(b, c) + squared_length(b) * cross(c, a) +
                   squared_length(c) * cross(a, b);
  return o + (0.5 / dot(a, cross(b, c))) * sum;
}

void set_terminals(const Scene& scene, double spacing, Random& random, SceneCut& cut) {
  const TetMesh& mesh = cut.mesh;
  const double seed_radius =
      scene.terminals == Terminals::hard ? seed_radius_in_spacings : sparse_seed_radius_in_spacings;
  cut.problem.seed.assign(mesh.size(), seed_outside);
  if (scene.terminals == Terminals::soft) cut.problem.preference.assign(mesh.size(), 0);
  for (Tet t = 0; t < mesh.finite; ++t) {
    const Vec3 centre = circumcentre(mesh, t);
    const double radius = distance(centre, mesh.points[mesh.vertices[t][0]]) / spacing;
    const bool inside = is_inside(scene.shape, centre);
    const double luck = uniform(random, 0, 1);
    cut.problem.seed[t] = seed_free;
    if (scene.terminals == Terminals::soft) {
      const double size = capacity_unit / 8 * std::fmin(radius, 4.0) * uniform(random, 0, 1);
      const auto preference = static_cast<std::int64_t>(size);
      cut.problem.preference[t] =
          (luck < wrong_preference_share) != inside ? preference : -preference;
    } else if (radius > seed_radius) {
      cut.problem.seed[t] = (luck < wrong_seed_share) != inside ? seed_inside : seed_outside;
    }
  }
}

void set_capacities(double spacing, unsigned threads, SceneCut& cut) {
  const TetMesh& mesh = cut.mesh;
  const double unit = capacity_unit / (spacing * spacing * spacing);
  cut.problem.capacity.assign(mesh.size(), {});
  parallel_for(mesh.finite, threads, [&](std::size_t t) {
    for (std::size_t i = 0; i < 4; ++i) {
      // From the lower side, so that rounding is the same on both.
      const Tet u = mesh.neighbours[t][i];
      const FacetDistance f = u < t
                                  ? facet_distance(mesh, u, mesh.facet_to(u, static_cast<Tet>(t)))
                                  : facet_distance(mesh, static_cast<Tet>(t), static_cast<int>(i));
      const double cost = std::min(f.area * f.mean_distance * unit, double{max_arc_capacity});
      cut.problem.capacity[t][i] = static_cast<std::int32_t>(cost);
    }
  });
}

}  // namespace

std::string name(const Scene& scene) {
  static constexpr const char* shapes[] = {"sphere", "torus", "plate"};
  static constexpr const char* flaws[] = {"clean", "noise", "outliers"};
  static constexpr const char* terminals[] = {"hard", "sparse", "soft"};
  return std::string(shapes[static_cast<int>(scene.shape)]) + "/" +
         flaws[static_cast<int>(scene.flaw)] + "/" + terminals[static_cast<int>(scene.terminals)];
}

SceneCut make_scene(const Scene& scene, std::size_t samples, Job& job) {
  Random random(samples + static_cast<unsigned>(scene.shape));
  const double spacing = std::sqrt(surface_area(scene.shape) / static_cast<double>(samples));
  SceneCut cut;
  cut.mesh = delaunay(sample(scene, samples, spacing, random), samples, job);
  set_terminals(scene, spacing, random, cut);
  set_capacities(spacing, job.threads(), cut);
  return cut;
}

}  // namespace arris
