#include "energy/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/vec.h"

namespace arris {
namespace {

using Corners = std::array<Vec3, 3>;

// ∫ r over the right triangle with the origin at an acute corner, the leg `p` there and the leg `q`
// opposite it. Odd in q, so a triangle is the sum of two, or their difference.
double right_triangle(double p, double q) {
  if (p <= 0) return 0;
  const double r = std::sqrt(p * p + q * q);
  // asinh(q / p), odd and without cancellation.
  const double angle = std::copysign(std::log((std::abs(q) + r) / p), q);
  return p / 6 * (q * r + p * p * angle);
}

// The Voronoi diagram of three points inside their own triangle: the integral of the distance to
// the nearest of them, and the places where that distance has its local maxima relative to any
// fourth point (the Voronoi vertices inside, and where bisectors leave the triangle).
struct OwnVoronoi {
  double integral = 0;
  std::array<Vec3, 4> extremes;
};

// Six right triangles about the circumcentre. `cosine` as in own_voronoi.
OwnVoronoi acute_voronoi(const Corners& x, const std::array<double, 3>& cosine, double twice_area) {
  OwnVoronoi v;
  Vec3 centre;
  double weights = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double edge2 = squared_length(x[i] - x[j]), half = 0.5 * std::sqrt(edge2);
    v.integral += 2 * right_triangle(half, half * cosine[k] / twice_area);
    v.extremes[k] = 0.5 * (x[i] + x[j]);
    centre = centre + (edge2 * cosine[k]) * x[k];  // barycentric weights of the circumcentre
    weights += edge2 * cosine[k];
  }
  v.extremes[3] = 1 / weights * centre;
  return v;
}

// c has the angle of at least pi/2. The bisectors of ca and cb meet ab in p and q; a and b own the
// tips beyond, c the rest.
OwnVoronoi obtuse_voronoi(Vec3 a, Vec3 b, Vec3 c, double cosine_a, double cosine_b,
                          double twice_area) {
  const double base = distance(a, b), height = twice_area / base;
  const double half_a = 0.5 * distance(a, c), half_b = 0.5 * distance(b, c);
  const double tan_a = twice_area / cosine_a, tan_b = twice_area / cosine_b;
  // Positions along ab: a at 0, b at base, the foot of c between them.
  const double foot = cosine_a / base;
  const double p = half_a * std::sqrt(1 + tan_a * tan_a);
  const double q = base - half_b * std::sqrt(1 + tan_b * tan_b);
  OwnVoronoi v;
  v.integral = 2 * right_triangle(half_a, half_a * tan_a) +
               2 * right_triangle(half_b, half_b * tan_b) + right_triangle(height, q - foot) -
               right_triangle(height, p - foot);
  v.extremes = {a + (p / base) * (b - a), a + (q / base) * (b - a), 0.5 * (a + c), 0.5 * (b + c)};
  return v;
}

OwnVoronoi own_voronoi(const Corners& x, double twice_area) {
  std::array<double, 3> cosine;  // of the angle, times the lengths of its two sides
  for (std::size_t k = 0; k < 3; ++k) cosine[k] = dot(x[(k + 1) % 3] - x[k], x[(k + 2) % 3] - x[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    if (cosine[k] <= 0) return obtuse_voronoi(x[i], x[j], x[k], cosine[i], cosine[j], twice_area);
  }
  return acute_voronoi(x, cosine, twice_area);
}

double nearest_squared(Vec3 p, const Vec3* samples, std::size_t count) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < count; ++k)
    nearest = std::min(nearest, squared_length(p - samples[k]));
  return nearest;
}

// Centroids of the subdivision of a triangle into `parts` squared similar ones, in units of two of
// its sides over `parts`.
constexpr int parts = 8;  // error below 2 %, mostly far below
constexpr std::size_t places = parts * parts;
using Places = std::array<double, places>;
struct Centroids {
  Places i{}, j{};
};
constexpr Centroids subdivide() {
  Centroids c;
  std::size_t size = 0;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; i + j < parts; ++j)
      for (int k = 1; k <= 2 && i + j + k <= parts; ++k) {
        c.i[size] = i + k / 3.0;
        c.j[size++] = j + k / 3.0;
      }
  return c;
}
constexpr Centroids centroids = subdivide();

// Mean over the triangle of the distance to the nearest sample, at those centroids. Coordinate by
// coordinate, for vector instructions.
double sampled_mean(const Corners& x, const Vec3* samples, std::size_t count) {
  const Vec3 u = 1.0 / parts * (x[1] - x[0]), v = 1.0 / parts * (x[2] - x[0]);
  Places px, py, pz, nearest;
  for (std::size_t k = 0; k < places; ++k) {
    const double i = centroids.i[k], j = centroids.j[k];
    px[k] = x[0].x + i * u.x + j * v.x;
    py[k] = x[0].y + i * u.y + j * v.y;
    pz[k] = x[0].z + i * u.z + j * v.z;
  }
  nearest.fill(std::numeric_limits<double>::infinity());
  for (std::size_t s = 0; s < count; ++s) {
    const Vec3 q = samples[s];
    for (std::size_t k = 0; k < places; ++k) {
      const double dx = px[k] - q.x, dy = py[k] - q.y, dz = pz[k] - q.z;
      const double d = dx * dx + dy * dy + dz * dz;
      nearest[k] = d < nearest[k] ? d : nearest[k];
    }
  }
  double sum = 0;
  for (const double d : nearest) sum += std::sqrt(d);
  return sum / places;
}

}  // namespace

FacetDistance facet_distance(const TetMesh& mesh, Tet t, int i) {
  const auto facet = static_cast<std::size_t>(i);
  Corners x;
  std::array<Vec3, 5> samples;  // those of the corners first
  std::size_t count = 0;
  const auto add = [&](Index v) {
    if (v != infinite_vertex) samples[count++] = mesh.points[mesh.nearest_sample(v)];
  };
  bool own = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Index v = mesh.vertices[t][static_cast<std::size_t>(facet_corners[facet][k])];
    x[k] = mesh.points[v];
    own = own && mesh.nearest_sample(v) == v;
    add(v);
  }
  add(mesh.vertices[t][facet]);
  const Tet n = mesh.neighbours[t][facet];
  add(mesh.vertices[n][static_cast<std::size_t>(mesh.facet_to(n, t))]);

  const double twice_area = length(cross(x[1] - x[0], x[2] - x[0]));
  FacetDistance result;
  result.area = 0.5 * twice_area;
  if (own && twice_area > 0) {
    // Exact, if no other sample is nearer anywhere: inside a Voronoi cell the difference of the
    // squared distances is linear, so it suffices to look at the corners of the cells.
    const OwnVoronoi voronoi = own_voronoi(x, twice_area);
    const auto none_nearer = [&](Vec3 p) {
      return nearest_squared(p, samples.data() + 3, count - 3) >=
             nearest_squared(p, samples.data(), 3);
    };
    if (std::all_of(voronoi.extremes.begin(), voronoi.extremes.end(), none_nearer)) {
      result.mean_distance = voronoi.integral / result.area;
      return result;
    }
  }
  result.mean_distance = sampled_mean(x, samples.data(), count);
  return result;
}

}  // namespace arris
