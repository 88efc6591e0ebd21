// Point samples of meshes, the inputs of tests of the whole pipeline. All are deterministic in
// their arguments, with the same bits on every platform.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arris/types.h"

namespace arris::test {

// The spacing of n samples as far apart as they can be on a surface of this area (hexagons).
double ideal_spacing(double area, std::size_t n);

// n independent samples, uniform by area. None lies on an edge.
std::vector<Vec3> sample_uniform(const Mesh& mesh, std::size_t n, std::uint64_t seed);

// n evenly spread samples (blue noise), none on an edge: five times as many uniform ones, of which
// the most crowded are removed one by one (Yuksel, Sample elimination for generating Poisson disk
// sample sets, 2015). Distances are straight, not along the surface. O(n log n).
std::vector<Vec3> sample_blue(const Mesh& mesh, std::size_t n, std::uint64_t seed);

// n samples: first the corners, then the sharp edges (turning by more than `edge_angle` degrees)
// at the spacing, then blue noise between them. At least all samples of corners and edges, even if
// they are more than n.
std::vector<Vec3> sample_feature(const Mesh& mesh, std::size_t n, std::uint64_t seed,
                                 double edge_angle = 30);

// Moves every point by noise of deviation sigma, in length units, in each coordinate.
void add_noise(std::vector<Vec3>& points, double sigma, std::uint64_t seed);

// Appends `count` points uniform in the bounding box padded by a tenth of its diagonal.
void add_outliers(std::vector<Vec3>& points, std::size_t count, std::uint64_t seed);

// Corners of the mesh, then points along its sharp edges, `spacing` apart or a little less; every
// chain of sharp edges between corners is divided evenly.
std::vector<Vec3> feature_points(const Mesh& mesh, double spacing, double edge_angle = 30);

}  // namespace arris::test
