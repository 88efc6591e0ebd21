// Point samples of triangle meshes, deterministic in their arguments, with a random generator of
// their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arris/types.h"

namespace arris::truth {

// Points with the direction in which their noise acts: the outward normal of the surface (on an
// edge or a corner the mean of those that meet there), or the ray for a scanned point. Unit length.
struct Samples {
  std::vector<Vec3> positions;
  std::vector<Vec3> directions;

  std::size_t size() const noexcept { return positions.size(); }
  void add(Vec3 position, Vec3 direction) {
    positions.push_back(position);
    directions.push_back(direction);
  }
};

enum class Mode : std::uint8_t {
  uniform,  // independent, uniform by area; none on an edge
  blue,     // blue noise: evenly spread, none on an edge
  feature,  // corners, then sharp edges at the spacing, then blue noise between them
  graded,   // blue noise whose density falls tenfold along a random direction
  scan,     // range images from several sides, with occlusion: see scanner.h
};

struct Sampling {
  Mode mode = Mode::blue;
  std::size_t samples = 10000;
  std::uint64_t seed = 1;
  double edge_angle = 30;  // degrees by which the surface turns at a sharp edge; for feature
  int views = 12;          // for scan
};

// Exactly `samples` points; in mode feature at least all those of corners and edges. Meshes may be
// open but for mode feature, whose boundary edges count as sharp. Throws std::invalid_argument if
// the mesh has no area, a face names no vertex, a vertex is not finite, or a scanner sees too
// little. O(n log n).
Samples sample(const Mesh& mesh, const Sampling& sampling);

// The spacing of n samples as far apart as they can be on a surface of this area (hexagons), and
// the number of samples that have that spacing.
double ideal_spacing(double area, std::size_t n);
std::size_t samples_at_spacing(double area, double spacing);

// The positions of the modes of these names, for tests.
std::vector<Vec3> sample_uniform(const Mesh& mesh, std::size_t n, std::uint64_t seed);
std::vector<Vec3> sample_blue(const Mesh& mesh, std::size_t n, std::uint64_t seed);
std::vector<Vec3> sample_feature(const Mesh& mesh, std::size_t n, std::uint64_t seed,
                                 double edge_angle = 30);

// Corners of the mesh, then points along its sharp edges, `spacing` apart or a little less; every
// chain of sharp edges between corners is divided evenly. A corner is where sharp edges end, meet
// or turn by more than the angle, and the tip of a cone: a vertex without sharp edges whose angles
// sum to less than 3/2 pi.
Samples feature_samples(const Mesh& mesh, double spacing, double edge_angle = 30);
std::vector<Vec3> feature_points(const Mesh& mesh, double spacing, double edge_angle = 30);

}  // namespace arris::truth
