#include "truth/scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "base/vec.h"
#include "truth/measure.h"
#include "truth/random.h"

namespace arris::truth {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double standoff = 2.5;  // distance of the eyes from the centre, in diagonals
constexpr double jitter = 0.25;   // of the eyes' directions
const double grazing = std::cos(80 * pi / 180);

// An eye and its image plane at distance 1: right, up and forward are orthonormal.
struct Eye {
  Vec3 at, right, up, forward;
  double half = 0;  // half the width of the image at distance 1
};

std::vector<Eye> place_eyes(const Mesh& mesh, int views, std::uint64_t seed) {
  const Bounds bounds = bounds_of(mesh.vertices);
  const double diagonal = bounds.diagonal();
  Random random(seed);
  const double spin = 2 * pi * random.unit();
  std::vector<Eye> eyes;
  for (int i = 0; i < views; ++i) {
    const double z = 1 - (2 * i + 1.0) / views, r = std::sqrt(1 - z * z);
    const double angle = spin + i * pi * (3 - std::sqrt(5.0));
    Vec3 out = Vec3{r * std::cos(angle), r * std::sin(angle), z} + jitter * random.direction();
    out = (1 / length(out)) * out;
    const Vec3 forward = -out;
    const Vec3 side = cross(forward, std::abs(out.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0});
    const Vec3 right = (1 / length(side)) * side;
    // The sphere round the bounding box fills the image.
    const double half = 0.5 / std::sqrt(standoff * standoff - 0.25);
    eyes.push_back({bounds.centre() + (standoff * diagonal) * out, right, cross(right, forward),
                    forward, half});
  }
  return eyes;
}

// A square image of the nearest triangle per pixel.
class RangeImage {
 public:
  RangeImage(const Eye& eye, std::size_t size)
      : eye_(eye), size_(size), depth_(size * size, infinity), triangle_(size * size, no_index) {}

  void draw(const Mesh& mesh) {
    for (Index t = 0; t < mesh.triangles.size(); ++t) draw_triangle(mesh, t);
  }

  // Appends the hits, row by row.
  void add_hits(const Mesh& mesh, Samples& samples) const {
    for (std::size_t y = 0; y < size_; ++y)
      for (std::size_t x = 0; x < size_; ++x) {
        const std::size_t i = y * size_ + x;
        if (triangle_[i] == no_index) continue;
        const Vec3 ray = position(x) * eye_.right + position(y) * eye_.up + eye_.forward;
        const Vec3 direction = (1 / length(ray)) * ray, n = normal(mesh, triangle_[i]);
        if (std::abs(dot(direction, n)) < grazing * length(n)) continue;
        samples.add(eye_.at + depth_[i] * ray, direction);
      }
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  struct Projected {
    double x, y;  // in pixels: the centre of pixel i is at i
  };

  // The centre of a pixel on the image plane.
  double position(std::size_t pixel) const {
    return (2 * (static_cast<double>(pixel) + 0.5) / static_cast<double>(size_) - 1) * eye_.half;
  }

  void draw_triangle(const Mesh& mesh, Index t) {
    std::array<Vec3, 3> p;  // in the frame of the eye
    std::array<Projected, 3> q;
    const double scale = static_cast<double>(size_) / 2;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 d = mesh.vertices[mesh.triangles[t][i]] - eye_.at;
      p[i] = {dot(d, eye_.right), dot(d, eye_.up), dot(d, eye_.forward)};
      q[i] = {(p[i].x / p[i].z / eye_.half + 1) * scale - 0.5,
              (p[i].y / p[i].z / eye_.half + 1) * scale - 0.5};
    }
    const Vec3 n = cross(p[1] - p[0], p[2] - p[0]);
    const auto [left, right] = std::minmax({q[0].x, q[1].x, q[2].x});
    const auto [low, high] = std::minmax({q[0].y, q[1].y, q[2].y});
    for (std::size_t y = first(low); y < last(high); ++y)
      for (std::size_t x = first(left); x < last(right); ++x)
        if (covers(q, static_cast<double>(x), static_cast<double>(y))) hit(t, n, p[0], x, y);
  }

  // The pixels whose centres lie between two positions.
  std::size_t first(double low) const { return clamped(std::ceil(low)); }
  std::size_t last(double high) const { return clamped(std::floor(high) + 1); }
  std::size_t clamped(double pixel) const {
    return static_cast<std::size_t>(std::clamp(pixel, 0.0, static_cast<double>(size_)));
  }

  // Pixels on an edge belong to both triangles, so that none falls between.
  static bool covers(const std::array<Projected, 3>& q, double x, double y) {
    int left = 0, right = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Projected a = q[i], b = q[(i + 1) % 3];
      const double side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
      left += side >= 0;
      right += side <= 0;
    }
    return left == 3 || right == 3;
  }

  // The ray through the pixel meets the plane of triangle t, with normal n and point a.
  void hit(Index t, Vec3 n, Vec3 a, std::size_t x, std::size_t y) {
    const double slope = dot(n, {position(x), position(y), 1});
    if (slope == 0) return;
    const double depth = dot(n, a) / slope;
    const std::size_t i = y * size_ + x;
    if (depth <= 0 || depth >= depth_[i]) return;
    depth_[i] = depth;
    triangle_[i] = t;
  }

  Eye eye_;
  std::size_t size_;
  std::vector<double> depth_;  // along the forward axis
  std::vector<Index> triangle_;
};

Samples shoot(const Mesh& mesh, const std::vector<Eye>& eyes, std::size_t size) {
  Samples samples;
  for (const Eye& eye : eyes) {
    RangeImage image(eye, size);
    image.draw(mesh);
    image.add_hits(mesh, samples);
  }
  return samples;
}

// Moves n random ones to the front and drops the rest.
void draw_some(Samples& samples, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = i + random.below(samples.size() - i);
    std::swap(samples.positions[i], samples.positions[j]);
    std::swap(samples.directions[i], samples.directions[j]);
  }
  samples.positions.resize(n);
  samples.directions.resize(n);
}

}  // namespace

Samples scan(const Mesh& mesh, std::size_t n, int views, std::uint64_t seed) {
  constexpr double largest_image = 8192;  // pixels a side
  const std::vector<Eye> eyes = place_eyes(mesh, views, seed);
  // The first guess: the model covers a third of each image. Then by the share of hits so far.
  double size = std::max(16.0, std::sqrt(3.0 * static_cast<double>(n) / views));
  for (; size <= largest_image; size = std::ceil(size)) {
    Samples samples = shoot(mesh, eyes, static_cast<std::size_t>(size));
    if (samples.size() >= n) {
      draw_some(samples, n, seed + 1);
      return samples;
    }
    const double lacking =
        static_cast<double>(n) / std::max(1.0, static_cast<double>(samples.size()));
    size *= 1.02 * std::sqrt(std::min(lacking, 16.0));
  }
  throw std::invalid_argument("the scanner sees too little of the mesh for so many points");
}

}  // namespace arris::truth
