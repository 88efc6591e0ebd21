// Clouds as scanners and users make them: samples with noise, outliers and missing patches.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arris/types.h"
#include "truth/samplers.h"

namespace arris::truth {

// Which way noise moves a point.
enum class NoiseDirection : std::uint8_t {
  along,      // to and fro along Samples::directions: the normal, or the ray of a scan
  isotropic,  // each coordinate alike
};

struct CloudOptions {
  Sampling sampling;

  double noise = 0;  // standard deviation: of the move along its line, or of each coordinate
  // Of what `noise` is a multiple: the spacing (ideal_spacing of the samples asked for), or the
  // diagonal of the bounding box of the mesh.
  bool noise_in_spacings = false;
  NoiseDirection noise_direction = NoiseDirection::along;

  double outliers = 0;  // as a share of the samples on the surface

  int missing = 0;               // patches without samples
  double missing_radius = 0.08;  // of each, in diagonals
};

struct Cloud {
  PointCloud points;         // coordinates are those of float32
  std::size_t missing = 0;   // samples that the patches took away
  std::size_t outliers = 0;  // among the points
  double spacing = 0;        // ideal_spacing of the samples asked for
};

// Draws samples, takes the missing patches out, moves the rest by noise, adds outliers, and
// shuffles, each with random numbers of its own, so that one option leaves the others' points as
// they are. Throws std::invalid_argument as sample does, and if nothing is left.
Cloud make_cloud(const Mesh& mesh, const CloudOptions& options);

// Removes the samples nearer than `radius` to any of `count` samples, which are three radii or
// more apart if the model is large enough.
void remove_patches(Samples& samples, int count, double radius, std::uint64_t seed);

// Noise of deviation sigma, in length units. Nearly normal: see Random::normal.
void add_noise(Samples& samples, double sigma, NoiseDirection direction, std::uint64_t seed);
void add_noise(std::vector<Vec3>& points, double sigma, std::uint64_t seed);  // isotropic

// Appends `count` points uniform in the bounding box padded by a tenth of its diagonal.
void add_outliers(std::vector<Vec3>& points, std::size_t count, std::uint64_t seed);

}  // namespace arris::truth
